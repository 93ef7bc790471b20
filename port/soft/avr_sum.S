; The sum and the difference of two numbers of IEEE 754 binary32, in place of those of libgcc, on an AVR with a
; multiplier: the algorithm of soft_add in port/soft/binary32.h, in bytes. GCC Internals: 4.2 Routines for floating
; point emulation; avr-gcc's calling convention: a in r25 to r22, b in r21 to r18, the result in r25 to r22, r1 zero.
#include "port/soft/avr_parts.inc"

    .section .text.soft_sum, "ax", @progbits
    .global __subsf3
    .global __addsf3
    .type __subsf3, @function
    .type __addsf3, @function

__subsf3:
    subi r21, 0x80
__addsf3:
    push r17
    ; The number with the larger magnitude comes first: x in r25 to r22, the other one, y, in r21 to r18.
    mov r26, r25
    andi r26, 0x7F
    mov r27, r21
    andi r27, 0x7F
    cp r22, r18
    cpc r23, r19
    cpc r24, r20
    cpc r26, r27
    sbc r26, r26
    exchanged r22, r18, r26
    exchanged r23, r19, r26
    exchanged r24, r20, r26
    exchanged r25, r21, r26
    ; T is the sign of x; r27 is all ones where the signs differ.
    bst r25, 7
    mov r27, r25
    eor r27, r21
    lsl r27
    sbc r27, r27
    fields r25, r24
    fields r21, r20
    unpacked r25, r24
    unpacked r21, r20
    ; Bit 7 of r17: x is an infinity or a NaN; bit 6: it is a NaN.
    mov r0, r24
    lsl r0
    or r0, r23
    or r0, r22
    cp r1, r0
    sbc r0, r0
    ldi r17, 0x40
    and r17, r0
    ori r17, 0x80
    cpi r25, 0xFF
    sbc r0, r0
    com r0
    and r17, r0
    ; y goes to the exponent of x. Both have their top bit at bit 30 of four bytes: x in r24, r23, r22, r31.
    mov r26, r25
    sub r26, r21
    clr r21
    to_the_right r20, r19, r18, r21, r26, r30, r31
    sticky r21, r30
    clr r31
    lsr r24
    ror r23
    ror r22
    ror r31
    ; The sum, of x and the complement of y where the signs differ. It is not negative.
    eor r21, r27
    eor r18, r27
    eor r19, r27
    eor r20, r27
    mov r0, r27
    lsr r0
    adc r31, r21
    adc r22, r18
    adc r23, r19
    adc r24, r20
    ; A sum of zero is +0 where the signs differ; infinity less infinity is a NaN.
    mov r26, r31
    or r26, r22
    or r26, r23
    or r26, r24
    cpi r26, 1
    sbc r26, r26
    and r27, r26
    sbrc r27, 0
    clt
    mov r30, r26
    andi r26, 0x40
    or r17, r26
    ; r19: the zeros above its highest one, of zero more than any exponent.
    mov r18, r31
    ldi r19, 24
    cpse r22, r1
    mov r18, r22
    cpse r22, r1
    ldi r19, 16
    cpse r23, r1
    mov r18, r23
    cpse r23, r1
    ldi r19, 8
    cpse r24, r1
    mov r18, r24
    cpse r24, r1
    ldi r19, 0
    zeros_added r18, r19, r20, r21
    or r19, r30
    ; The highest one goes to bit 31, as far as the exponent lets it: that is then one more, less the places.
    cp r25, r19
    sbc r26, r26
    mov r18, r25
    exchanged r19, r18, r26
    sub r25, r19
    ; By 16 and by 8 places to the left.
    sbrc r19, 4
    mov r24, r22
    sbrc r19, 4
    mov r23, r31
    sbrc r19, 4
    mov r22, r1
    sbrc r19, 4
    mov r31, r1
    sbrc r19, 3
    mov r24, r23
    sbrc r19, 3
    mov r23, r22
    sbrc r19, 3
    mov r22, r31
    sbrc r19, 3
    mov r31, r1
    ; By 0 to 7: times a power of two.
    power r18, r19
    mul r24, r18
    mov r24, r0
    mul r23, r18
    mov r23, r0
    or r24, r1
    mul r22, r18
    mov r22, r0
    or r23, r1
    mul r31, r18
    mov r31, r0
    or r22, r1
    clr r1
    ; The field of the exponent without the top bit.
    clr r19
    lsr r25
    ror r19
    packed
    bld r25, 7
    pop r17
    ret
