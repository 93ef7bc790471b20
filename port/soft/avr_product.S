; The product of two numbers of IEEE 754 binary32, in place of that of libgcc, on an AVR with a multiplier: the algorithm
; of soft_multiply in port/soft/binary32.h, in bytes. GCC Internals: 4.2 Routines for floating point emulation;
; avr-gcc's calling convention: a in r25 to r22, b in r21 to r18, the result in r25 to r22, r1 zero.
#include "port/soft/avr_parts.inc"

    .section .text.soft_product, "ax", @progbits
    .global __mulsf3
    .type __mulsf3, @function

__mulsf3:
    push r16
    push r17
    push r28
    push r29
    ; T is the sign of the result.
    mov r0, r25
    eor r0, r21
    bst r0, 7
    fields r25, r24
    fields r21, r20
    ; Bit 6 of r16: a or b is a NaN; 0xFF000000 is less than the bits behind its sign.
    ldi r17, 0xFF
    cp r1, r22
    cpc r1, r23
    cpc r1, r24
    cpc r17, r25
    sbc r16, r16
    cp r1, r18
    cpc r1, r19
    cpc r1, r20
    cpc r17, r21
    sbc r0, r0
    or r16, r0
    andi r16, 0x40
    ; Bit 7 of r17: a or b is an infinity or a NaN.
    cpi r25, 0xFF
    sbc r0, r0
    cpi r21, 0xFF
    sbc r17, r17
    and r17, r0
    com r17
    andi r17, 0x80
    or r17, r16
    ; x in r24, r23, r22, and y in r20, r19, r18: a number below the least normal one is y. If both are, the result is 0
    ; whatever their significands.
    cpi r25, 1
    sbc r16, r16
    unpacked r25, r24
    unpacked r21, r20
    exchanged r25, r21, r16
    exchanged r24, r20, r16
    exchanged r23, r19, r16
    exchanged r22, r18, r16
    ; r27: the zeros above the highest one of y, which goes to the top.
    mov r26, r18
    ldi r27, 16
    cpse r19, r1
    mov r26, r19
    cpse r19, r1
    ldi r27, 8
    cpse r20, r1
    mov r26, r20
    cpse r20, r1
    ldi r27, 0
    zeros_added r26, r27, r30, r31
    sbrc r27, 4
    mov r20, r18
    sbrc r27, 4
    mov r19, r1
    sbrc r27, 4
    mov r18, r1
    sbrc r27, 3
    mov r20, r19
    sbrc r27, 3
    mov r19, r18
    sbrc r27, 3
    mov r18, r1
    power r26, r27
    mul r20, r26
    mov r20, r0
    mul r19, r26
    mov r19, r0
    or r20, r1
    mul r18, r26
    mov r18, r0
    or r19, r1
    clr r1
    ; r29, r28: the field of the exponent without the top bit, where that is bit 47 of the product. Of a y that is zero
    ; it is less than any; a NaN is then infinity times zero.
    mov r28, r25
    clr r29
    add r28, r21
    adc r29, r1
    subi r28, 127
    sbci r29, 0
    sub r28, r27
    sbc r29, r1
    sbrs r20, 7
    ldi r29, 0xC0
    sbrs r20, 7
    ori r17, 0x40
    ; The product, the highest byte first: r30, r27, r26, r31, r25, r21; column by column.
    clr r16
    mul r22, r18
    mov r21, r0
    mov r25, r1
    clr r31
    mul r22, r19
    add r25, r0
    adc r31, r1
    clr r26
    mul r23, r18
    add r25, r0
    adc r31, r1
    adc r26, r16
    mul r22, r20
    add r31, r0
    adc r26, r1
    clr r27
    adc r27, r16
    mul r23, r19
    add r31, r0
    adc r26, r1
    adc r27, r16
    mul r24, r18
    add r31, r0
    adc r26, r1
    adc r27, r16
    mul r23, r20
    add r26, r0
    adc r27, r1
    clr r30
    adc r30, r16
    mul r24, r19
    add r26, r0
    adc r27, r1
    adc r30, r16
    mul r24, r20
    add r27, r0
    adc r30, r1
    clr r1
    movw r22, r26
    mov r24, r30
    or r21, r25
    sticky r31, r21
    ; Where bit 47 is not set, twice that.
    mov r0, r24
    lsl r0
    sbc r0, r0
    com r0
    mov r18, r31
    and r18, r0
    add r31, r18
    mov r18, r22
    and r18, r0
    adc r22, r18
    mov r18, r23
    and r18, r0
    adc r23, r18
    mov r18, r24
    and r18, r0
    adc r24, r18
    add r28, r0
    adc r29, r0
    ; A field below 0 becomes 0, and the significand goes so far to the right: r18, of more than 255 places 255.
    clr r18
    clr r19
    sub r18, r28
    sbc r19, r29
    mov r0, r29
    lsl r0
    sbc r0, r0
    and r18, r0
    and r19, r0
    com r0
    and r28, r0
    and r29, r0
    cp r1, r19
    sbc r0, r0
    or r18, r0
    to_the_right r24, r23, r22, r31, r18, r30, r26
    lsl r31
    rol r22
    rol r23
    rol r24
    sticky r31, r30
    ; The field's lowest bit goes to r19.
    clr r19
    lsr r29
    ror r28
    ror r19
    mov r25, r28
    packed
    bld r25, 7
    pop r29
    pop r28
    pop r17
    pop r16
    ret
