/* The second stage: 256 bytes that the boot ROM copies into RAM and runs, if their checksum is right. It lets flash be
 * read as memory, with the command 03h, which all chips have, at a quarter of the clock of the system, and starts the
 * program behind it. The program reads flash once, to copy itself into RAM: a faster way is not worth its lines.
 * RP2040 Datasheet: 2.8.1.3 second stage and checksum, 4.10.13 SSI, registers. */
    .syntax unified
    .cpu cortex-m0plus
    .thumb

    .equ SSI, 0x18000000
    .equ CTRLR0, 0x00
    .equ CTRLR1, 0x04
    .equ SSIENR, 0x08
    .equ BAUDR, 0x14
    .equ SPI_CTRLR0, 0xF4
    .equ VTOR, 0xE000ED08
    .equ PROGRAM, 0x10000100

    .section .boot2, "ax"
boot2:
    ldr r3, =SSI
    movs r1, #0
    str r1, [r3, #SSIENR]
    movs r1, #4
    str r1, [r3, #BAUDR]
    ldr r1, =(31 << 16 | 3 << 8)                // frames of 32 bits; EEPROM read: an address out, then data in
    str r1, [r3, #CTRLR0]
    movs r1, #0                                 // one frame
    str r1, [r3, #CTRLR1]
    ldr r1, =(0x03 << 24 | 2 << 8 | 6 << 2)     // the command, of 8 bits, and an address of 24, both on one wire
    ldr r0, =(SSI + SPI_CTRLR0)
    str r1, [r0]
    movs r1, #1
    str r1, [r3, #SSIENR]
    ldr r0, =PROGRAM
    ldr r1, =VTOR
    str r0, [r1]
    ldm r0, {r0, r1}
    msr msp, r0
    bx r1
    .pool
    .org 252
    .word 0x3c019546                            // the checksum: tests/port/test_rp2040.py computes it
