PRG 0                                ;* Start of Program 0
HSPD=1000                            ;* Set high speed to 1000 pps
LSPD=500                             ;* Set low speed to 500pps
ACC=500                              ;* Set acceleration to 500ms
TOC=5000                             ;* Set time-out counter alarm to 5 seconds
EO=1                                  ;* Enable motor
WHILE 1=1                             ;* Forever loop
    X0                                ;* Move to position 0
    WAITX                             ;* Wait for the move to complete
    X1000                             ;* Move to position 1000
    WAITX                             ;* Wait for the move to complete
ENDWHILE                             ;* Go back to WHILE statement
END                                    ;* End Program 0

PRG 1                                ;* Start of Program 1
WHILE 1=1                             ;* Forever loop
    V1=MSTX&2048                     ;* Get bit time-out counter alarm variable
    IF V1 = 2048                      ;* If time-out counter alarm is on
        SR0=0                         ;* Stop program 0
        ABORTX                        ;* Abort the motor
        DO=0                          ;* Set DO=0
        DELAY=3000;                   ;* Delay 3 seconds
        SR0=1                         ;* Turn program 0 back on
        DO=1                          ;* Set DO=1
    ENDIF
ENDWHILE                             ;* Go back to WHILE statement
END                                    ;* End Program 1

; PMX manual, ch. 11, example 8, as printed.
;# for pmx-4ex-sa
;# start 0 1
;# after 3000 state0=1 state1=1 least:move_X1000=1 count:abort_X=0
;# at 3000 MSTX=2048
;# after 4000 state0=0 count:abort_X=1 DO=0
;# after 8000 state0=1 state1=1 DO=1 count:abort_X=1 MSTX=0..7 least:move_X1000=2
