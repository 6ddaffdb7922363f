HSPD=20000      ;* Set the high speed to 20000 pulses/sec
LSPD=1000       ;* Set the low speed to 1000 pulses/sec
ACC=300         ;* Set the acceleration to 300 msec
EO=1            ;* Enable the motor power
WHILE 1=1       ;* Forever loop
    X0           ;* Move to zero
    WAITX        ;* Wait for X-axis move to complete
    X1000        ;* Move to 1000
    WAITX        ;* Wait for X-axis move to complete
ENDWHILE        ;* Go back to WHILE statement
END

; PMX manual, ch. 11, example 2, as printed.
;# for pmx-4ex-sa
;# after 10000 state0=1 least:move_X0=90 least:move_X1000=90
