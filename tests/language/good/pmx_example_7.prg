PRG 0                                ;* Start of Program 0
HSPD=20000                          ;* Set high speed to 20000pps
LSPD=500                             ;* Set low speed to 500pps
ACC=500                              ;* Set acceleration to 500ms
WHILE 1=1                            ;* Forever loop
    X0                                ;* Move to position 0
    WAITX                             ;* Wait for the move to complete
    X1000                             ;* Move to position 1000
    WAITX                             ;* Wait for the move to complete
ENDWHILE                             ;* Go back to WHILE statement
END                                  ;* End Program 0

PRG 1                                ;* Start of Program 1
WHILE 1=1                            ;* Forever loop
    IF DI1=1                          ;* If digital input 1 is triggered
        ABORTX                        ;* Stop movement
        SR0=0                         ;* Stop Program 1
    ELSE                              ;* If digital input 1 is not triggered
        SR0=1                         ;* Run Program 1
    ENDIF                             ;* End if statements
ENDWHILE                             ;* Go back to WHILE statement
END                                  ;* End Program 1

; PMX manual, ch. 11, example 7, as printed.
;# for pmx-4ex-sa
;# start 1
;# after 1000 state0=1 state1=1 least:move_X1000=8
;# at 1000 DI1=1
;# after 1100 state0=0 state1=1 did:abort_X
;# at 2000 DI1=0
;# after 2100 state0=1
;# after 3000 least:move_X1000=16
