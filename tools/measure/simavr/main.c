/* Each instruction that an ATmega1284P executes in simavr, for `cycles`:
 *
 *     simavr_trace PROGRAM NANOSECONDS
 *
 * prints a line `=ADDRESS STACK CYCLE` for each, in hexadecimal digits: before it the program counter, the stack
 * pointer and the cycles until then. As in port/atmega1284p/run.sh the duration stands in the EEPROM, and the program
 * ends where it sleeps without interrupts. Of a program that does not end in STEPS_MOST instructions no more is shown.
 */
#include <inttypes.h>
#include <simavr/avr_eeprom.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <stdlib.h>

enum { STACK_LOW = 0x5D, STACK_HIGH = 0x5E, BYTE_BITS = 8, STEPS_MOST = 200000000 };

/* Time passes in cycles alone. */
static void sleep_no_time(avr_t *const avr, const avr_cycle_count_t cycles)
{
    (void)avr;
    (void)cycles;
}

static avr_t *prepared(const char *const program, const uint64_t nanoseconds)
{
    static elf_firmware_t firmware;
    uint8_t duration[sizeof nanoseconds];
    avr_t *const avr = avr_make_mcu_by_name("atmega1284p");
    if (avr == NULL || elf_read_firmware(program, &firmware) != 0 || avr_init(avr) != 0) {
        fprintf(stderr, "simavr_trace: cannot run %s\n", program);
        exit(EXIT_FAILURE);
    }
    avr->log = LOG_ERROR;
    avr->frequency = 1000000000;
    avr->sleep = sleep_no_time;
    avr->run_cycle_limit = 1; /* one instruction at a time */
    avr_load_firmware(avr, &firmware);
    for (size_t i = 0; i < sizeof duration; i++) {
        duration[i] = (uint8_t)(nanoseconds >> (i * BYTE_BITS));
    }
    avr_eeprom_desc_t eeprom = {.ee = duration, .offset = 0, .size = sizeof duration};
    avr_ioctl(avr, AVR_IOCTL_EEPROM_SET, &eeprom);
    uint32_t flags = 0;
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    return avr;
}

int main(const int argc, char **const argv)
{
    if (argc != 3) {
        fputs("usage: simavr_trace PROGRAM NANOSECONDS\n", stderr);
        return EXIT_FAILURE;
    }
    avr_t *const avr = prepared(argv[1], strtoull(argv[2], NULL, 10));
    int state = cpu_Running;
    for (uint32_t i = 0; i < STEPS_MOST && state != cpu_Done && state != cpu_Crashed;) {
        if (avr->state == cpu_Running) {
            i++;
            printf("=%" PRIx32 " %x %" PRIx64 "\n", (uint32_t)avr->pc,
                   avr->data[STACK_LOW] | (unsigned)avr->data[STACK_HIGH] << BYTE_BITS, (uint64_t)avr->cycle);
        }
        state = avr_run(avr);
    }
    return fflush(stdout) == 0 && state == cpu_Done ? EXIT_SUCCESS : EXIT_FAILURE;
}
