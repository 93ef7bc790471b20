#include "tools/isoc/emit/emit.h"

#include <stdbool.h>
#include <string.h>

#include "tools/isoc/base/embedded.h"

enum { LONGEST_PREFIX = 40 };

/* Keywords of C11 (6.4.1), C23 and C++23 (lex.key) that begin with a letter and have no capitals. */
static const char keywords[] =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class "
    "compl concept const const_cast consteval constexpr constinit continue co_await co_return co_yield decltype "
    "default "
    "delete do double dynamic_cast else enum explicit export extern false float for fortran friend goto if inline int "
    "long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public register "
    "reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast struct switch "
    "template this thread_local throw true try typedef typeid typename typeof typeof_unqual union unsigned using "
    "virtual void volatile wchar_t while xor xor_eq ";

/* Headers: of C (7.1.2), of POSIX.1 (2017, XBD 13), and further ones of glibc, newlib, picolibc and compilers. */
static const char headers[] =
    " assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg stdatomic "
    "stdbit stdbool stdckdint stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype "
    "aio cpio dirent dlfcn fcntl fmtmsg fnmatch ftw glob grp iconv langinfo libgen libintl monetary mqueue ndbm netdb "
    "nl_types poll pthread pwd regex sched search semaphore spawn strings stropts syslog tar termios trace ulimit "
    "unistd utime utmpx wordexp "
    "aliases alloca ar argp argz bits byteswap crypt devctl elf endian envlock envz err error execinfo expat "
    "fastmath features fpu_control fstab fts gcov gconv getopt gshadow ieee754 ieeefp ifaddrs lastlog libio link "
    "malloc mcheck memory mntent newlib obstack paths picolibc picotls printf proc_service pty quadmath re_comp reent "
    "regdef regexp resolv rpc sgtty shadow stab stdfix stdio_ext syscall syscalls sysexits syslimits termio thread_db "
    "tls ttyent ucontext unctrl unwind utmp values varargs wait winsock2 windows xlocale "
    "altivec cpuid cpuid_compat immintrin intrin mmintrin x86intrin arm_acle arm_bf16 arm_cde arm_cmse arm_fp16 "
    "arm_mve arm_mve_types arm_neon avr ";

static bool is_among(const char *word, const char *list, arena *memory)
{
    return strstr(list, arena_format(memory, " %s ", word)) != NULL;
}

/* The path of the header of core that is called so; NULL if none is. */
static const char *header_of_core(const char *word, arena *memory)
{
    const char *wanted = arena_format(memory, "/%s.h", word);
    const char *found = NULL;
    for (const embedded_file *f = core_files; f->path != NULL && found == NULL; f++) {
        const char *last = strrchr(f->path, '/');
        found = last != NULL && strcmp(last, wanted) == 0 ? f->path : NULL;
    }
    return found;
}

const char *prefix_fault(const char *prefix, arena *memory)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz", others[] = "abcdefghijklmnopqrstuvwxyz0123456789_";
    const size_t length = strlen(prefix);
    if (length > LONGEST_PREFIX || strspn(prefix, letters) == 0 || strspn(prefix, others) != length ||
        strncmp(prefix, "iso", 3) == 0) {
        return "it is a word of a-z, 0-9 and _, at most 40, that does not begin with iso";
    }
    if (strstr(prefix, "__") != NULL || prefix[length - 1] == '_') {
        return "two _ in a row are reserved in C++, and one is put behind it";
    }
    if (is_among(prefix, keywords, memory)) {
        return "it is a keyword of C or C++";
    }
    if (is_among(prefix, headers, memory)) {
        return arena_format(memory, "%s.h would hide the header <%s.h> of the system", prefix, prefix);
    }
    if (strcmp(prefix, "main") == 0) {
        return "main.c is where a program begins";
    }
    const char *of_core = header_of_core(prefix, memory);
    return of_core == NULL ? NULL : arena_format(memory, "%s.h is also called so: %s", prefix, of_core);
}
