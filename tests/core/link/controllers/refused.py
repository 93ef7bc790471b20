# Whether the plant, or its module, refuses a call for a reason.
def is_refused_by(error):
    def is_refused(why, call, *arguments):
        try:
            call(*arguments)
        except error as refusal:
            return why in str(refusal)
        return False

    return is_refused
