HSPD=20000          ;* Set the high speed to 20000 pulses/sec
LSPD=1000           ;* Set the low speed to 1000 pulses/sec
ACC=300             ;* Set the acceleration to 300 msec
EO=1                ;* Enable the motor power
WHILE 1=1           ;* Forever loop
    IF DI1=1        ;* If digital input 1 is on, execute the statements
        X0          ;* Move to zero
        WAITX       ;* Wait for X-axis move to complete
        X1000       ;* Move to 1000
        WAITX       ;* Wait for X-axis move to complete
    ENDIF
ENDWHILE            ;* Go back to WHILE statement
END

; PMX manual, ch. 11, example 4, as printed.
;# for pmx-4ex-sa
;# after 500 count:move_X1000=0 state0=1
;# at 500 DI1=1
;# after 1500 least:move_X1000=8
;# at 1500 DI1=0
;# after 1700 PX=1000
