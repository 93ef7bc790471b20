"""The front door: the table of commands and options, and what is made of it: parsing, help, completion, a man page."""
