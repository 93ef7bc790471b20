# Text files as strings in C, for tools/isoc/base/embedded.h.
#
#     awk -f embed.awk ARRAY FILE...
BEGIN {
    print "#include \"tools/isoc/base/embedded.h\"\n\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n"
    printf "const embedded_file %s[] = {\n", ARGV[1]
    for (i = 2; i < ARGC; i++) {
        printf "{\"%s\", \"\"\n", ARGV[i]
        while ((getline line <ARGV[i]) > 0) {
            gsub(/[\\"?]/, "\\\\&", line)
            printf "\"%s\\n\"\n", line
        }
        close(ARGV[i])
        print "},"
    }
    print "{0, 0}};"
}
