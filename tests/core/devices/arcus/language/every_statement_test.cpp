// Every row of the tables of both standalone languages: what it compiles to, and what it does.
#include <fstream>
#include <set>
#include <span>
#include <sstream>

#include <gtest/gtest.h>

#include "fake_controller.h"

namespace hw::arcus::language {
namespace {

struct Case {
  std::string id;      ///< without the model: "acc.get"
  std::string given;   ///< values before the start: "DI1=1 V3=7"
  std::string text;    ///< statements, `|` between; END is added unless it is there
  std::string code;    ///< low-level lines, `|` between, without the added END
  std::string effect;  ///< 50 ms later, `;` between: "V1=500", "did home X+ switch", "state0=0", "not done"
};

// The same in both languages.
const std::vector<Case> common_cases = {
    {"comment", "", "; X1000|V1=1 ; V1=2|*** V1=3|V2=1;", "SET,V1,1|SET,V2,1", "V1=1;V2=1"},
    {"if", "V1=1", "IF V1=1|V2=5|ENDIF|IF V1>1|V3=5|ENDIF",
     "IF,3|+TEST,V1,EQ,1,3|SET,V2,5|ENDIF|IF,7|+TEST,V1,GT,1,7|SET,V3,5|ENDIF", "V2=5;V3=0"},
    {"else", "V1=2", "IF V1=1|V2=5|ELSE|V2=6|ENDIF", "IF,5|+TEST,V1,EQ,1,4|SET,V2,5|ELSE,5|SET,V2,6|ENDIF",
     "V2=6"},
    {"elseif", "V1=2", "IF V1=1|V2=5|ELSEIF V1=2|V2=6|ELSEIF V1<3|V2=7|ENDIF",
     "IF,9|+TEST,V1,EQ,1,4|SET,V2,5|ELSEIF,9|+TEST,V1,EQ,2,7|SET,V2,6|ELSEIF,9|+TEST,V1,LT,3,9|SET,V2,7|"
     "ENDIF",
     "V2=6"},
    {"endif", "V1=1", "IF V1!=1|V2=1|ENDIF|V3=1", "IF,3|+TEST,V1,NE,1,3|SET,V2,1|ENDIF|SET,V3,1",
     "V2=0;V3=1"},
    {"while", "", "WHILE V1<=3|V1=V1+1|ENDWHILE", "WHILE,4|+TEST,V1,LE,3,5|READ,V1|+ADD,1,V1|ENDWHILE,0",
     "V1=4"},
    {"endwhile", "V2=9", "WHILE V1<3|V1=V1+1|ENDWHILE|V2=V1",
     "WHILE,4|+TEST,V1,LT,3,5|READ,V1|+ADD,1,V1|ENDWHILE,0|SET,V2,V1", "V2=3"},
    {"end", "", "V1=1|END|SUB 2|V1=2|ENDSUB", "SET,V1,1|END|SUB,2|SET,V1,2|ENDSUB", "V1=1;state0=0"},
    {"gosub", "", "GOSUB 31|V2=V1|END|SUB 31|V1=7|ENDSUB", "GOSUB,31|SET,V2,V1|END|SUB,31|SET,V1,7|ENDSUB",
     "V2=7;state0=0"},
    {"sub", "", "GOSUB 0|END|SUB 0|V1=3|ENDSUB|SUB 1|V1=4|ENDSUB",
     "GOSUB,0|END|SUB,0|SET,V1,3|ENDSUB|SUB,1|SET,V1,4|ENDSUB", "V1=3"},
    {"endsub", "", "GOSUB 1|V2=8|END|SUB 1|ENDSUB", "GOSUB,1|SET,V2,8|END|SUB,1|ENDSUB", "V2=8"},
    {"prg", "", "PRG 0|V1=1|END|PRG 1|V1=2|END", "PRG,0|SET,V1,1|END|PRG,1|SET,V1,2|END",
     "V1=1;state0=0;state1=0"},
    {"sr", "",
     "PRG 0|SR1=1|DELAY=5|SR1=2|DELAY=5|SR1=3|DELAY=1|SR1=0|END|PRG 1|WHILE 1=1|V1=V1+1|ENDWHILE|END",
     "PRG,0|SR,1,1|DELAY,5|SR,1,2|DELAY,5|SR,1,3|DELAY,1|SR,1,0|END|PRG,1|WHILE,14|+TEST,1,EQ,1,15|READ,V1|+"
     "ADD,1,V1|"
     "ENDWHILE,10|END",
     "state1=0;V1=2"},
    {"delay", "", "V1=1|DELAY=40|V2=1|DELAY=40|V3=1", "SET,V1,1|DELAY,40|SET,V2,1|DELAY,40|SET,V3,1",
     "V2=1;V3=0;state0=1"},
    {"store", "", "STORE", "STORE", "did store"},
    {"v.set", "", "V1=12345|V99=V1", "SET,V1,12345|SET,V99,V1", "V99=12345"},
    {"v.op", "V1=13",
     "V2=V1+1|V3=V1-20|V4=V1*2|V5=V1/4|V6=V1%4|V7=V1>>1|V8=V1<<2|V9=V1&6|V10=V1|2",  // the last | is the
                                                                                     // operator
     "READ,V1|+ADD,1,V2|READ,V1|+SUB,20,V3|READ,V1|+MUL,2,V4|READ,V1|+DIV,4,V5|READ,V1|+MOD,4,V6|READ,V1|+"
     "SHR,1,V7|"
     "READ,V1|+SHL,2,V8|READ,V1|+AND,6,V9|READ,V1|+OR,2,V10",
     "V2=14;V3=-7;V4=26;V5=3;V6=1;V7=6;V8=52;V9=4;V10=15"},
    {"v.not", "EO=5", "V5=~EO|V6=~0", "READ,EO|+NOT,V5|READ,0|+NOT,V6", "V5=-6;V6=-1"},
    {"v.get", "V1=4", "V3=V1", "SET,V3,V1", "V3=4"},
    {"abs", "", "INC|ABS|X7|WAITX|X7", "INC|ABS|MOVE,X,7|WAIT,X|MOVE,X,7", "PX=7;did absolute"},
    {"inc", "", "INC|X7|WAITX|X7|WAITX", "INC|MOVE,X,7|WAIT,X|MOVE,X,7|WAIT,X", "PX=14;did incremental"},
    {"acc.get", "ACC=321", "V1=ACC", "READ,ACC|+PUT,V1", "V1=321"},
    {"acc.set", "V3=500", "ACC=300|ACC=V3", "SET,ACC,300|SET,ACC,V3", "ACC=500"},
    {"dec.get", "DEC=321", "V1=DEC", "READ,DEC|+PUT,V1", "V1=321"},
    {"dec.set", "V3=500", "DEC=300|DEC=V3", "SET,DEC,300|SET,DEC,V3", "DEC=500"},
    {"hspd.get", "HSPD=4000", "V1=HSPD", "READ,HSPD|+PUT,V1", "V1=4000"},
    {"hspd.set", "V1=2500", "HSPD=10000|HSPD=V1", "SET,HSPD,10000|SET,HSPD,V1", "HSPD=2500"},
    {"lspd.get", "LSPD=40", "V1=LSPD", "READ,LSPD|+PUT,V1", "V1=40"},
    {"lspd.set", "V1=500", "LSPD=1000|LSPD=V1", "SET,LSPD,1000|SET,LSPD,V1", "LSPD=500"},
    {"di.get", "DI=255", "IF DI=255|V1=1|ENDIF", "IF,3|+TEST,DI,EQ,255,3|SET,V1,1|ENDIF", "V1=1"},
    {"di.bit.get", "DI1=1 DI2=0", "V1=DI1|IF DI2=1|V2=1|ENDIF",
     "READ,DI1|+PUT,V1|IF,5|+TEST,DI2,EQ,1,5|SET,V2,1|ENDIF", "V1=1;V2=0"},
    {"do.get", "DO=5", "V1=DO", "READ,DO|+PUT,V1", "V1=5"},
    {"do.set", "V1=3", "DO=7|DO=V1", "SET,DO,7|SET,DO,V1", "DO=3"},
    {"do.bit.get", "DO3=1", "V1=DO3", "READ,DO3|+PUT,V1", "V1=1"},
    {"do.bit.set", "V1=1", "DO3=1|DO2=V1", "SET,DO3,1|SET,DO2,V1", "DO3=1;DO2=1"},
    {"eo.get", "EO=1", "V1=EO", "READ,EO|+PUT,V1", "V1=1"},
    {"eo.set", "V1=1", "EO=0|EO=V1", "SET,EO,0|SET,EO,V1", "EO=1"},
    {"toc.set", "", "TOC=300", "SET,TOC,300", "TOC=300"},
};

const std::vector<Case> pmx_cases = {
    {"abort", "", "JOGX+|JOGY+|DELAY=5|ABORT|V1=PX", "JOG,X,+|JOG,Y,+|DELAY,5|ABORT|READ,PX|+PUT,V1",
     "did abort X Y Z U"},
    {"abort.axis", "", "JOGX+|JOGY+|ABORTY|WAITY", "JOG,X,+|JOG,Y,+|ABORT,Y|WAIT,Y", "did abort Y;state0=0"},
    {"stop", "", "JOGX+|STOP|WAITX", "JOG,X,+|STOP|WAIT,X", "did stop X Y Z U;state0=0"},
    {"stop.axis", "", "JOGZ+|STOPZ|WAITZ", "JOG,Z,+|STOP,Z|WAIT,Z", "did stop Z;state0=0"},
    {"acc.axis.get", "ACCX=7 ACC=9", "V1=ACCX", "READ,ACCX|+PUT,V1", "V1=7"},
    {"acc.axis.set", "V3=500", "ACCX=300|ACCU=V3", "SET,ACCX,300|SET,ACCU,V3", "ACCX=300;ACCU=500"},
    {"dec.axis.get", "DECU=7", "V1=DECU", "READ,DECU|+PUT,V1", "V1=7"},
    {"dec.axis.set", "V3=500", "DECX=300|DECY=V3", "SET,DECX,300|SET,DECY,V3", "DECX=300;DECY=500"},
    {"hspd.axis.get", "HSPDY=7", "V1=HSPDY", "READ,HSPDY|+PUT,V1", "V1=7"},
    {"hspd.axis.set", "V1=2500", "HSPDY=10000|HSPDX=V1|HSPDZ=0", "SET,HSPDY,10000|SET,HSPDX,V1|SET,HSPDZ,0",
     "HSPDY=10000;HSPDX=2500"},
    {"lspd.axis.get", "LSPDZ=7", "V1=LSPDZ", "READ,LSPDZ|+PUT,V1", "V1=7"},
    {"lspd.axis.set", "V1=500", "LSPDZ=1000|LSPDU=V1", "SET,LSPDZ,1000|SET,LSPDU,V1", "LSPDZ=1000;LSPDU=500"},
    {"ai.get", "AI1=499 AI8=4000", "IF AI1<500|DO=1|ENDIF|V1=AI8",
     "IF,3|+TEST,AI1,LT,500,3|SET,DO,1|ENDIF|READ,AI8|+PUT,V1", "DO=1;V1=4000"},
    {"arc.cw", "", "ARCP1000:0:90000:90000|WAITX", "ARCP|+X,1000|+Y,0|+TO,90000,90000|WAIT,X",
     "did arc cw 1000 0 to 90000 by 90000;state0=0"},
    {"arc.ccw", "", "ARCN0:-1000:0:180000|WAITY", "ARCN|+X,0|+Y,-1000|+TO,0,180000|WAIT,Y",
     "did arc ccw 0 -1000 to 0 by 180000;state0=0"},
    {"cir.cw", "", "CIRP1000:1000", "CIRP|+X,1000|+Y,1000", "did circle cw 1000 1000"},
    {"cir.ccw", "", "CIRN0:2000", "CIRN|+X,0|+Y,2000", "did circle ccw 0 2000"},
    {"dio.set", "", "DIO=6", "SET,DO,6", "DO=6"},
    {"e.get", "EU=-3", "V1=EU", "READ,EU|+PUT,V1", "V1=-3"},
    {"e.set", "V1=5 EX=9", "EX=0|EY=V1", "SET,EX,0|SET,EY,V1", "EX=0;EY=5"},
    {"eclear", "", "ECLEARU", "ECLEAR,U", "did clear U"},
    {"eo.bit.get", "EO4=1", "V1=EO4", "READ,EO4|+PUT,V1", "V1=1"},
    {"eo.bit.set", "V2=1", "EO1=31|EO2=V2", "SET,EO1,31|SET,EO2,V2", "EO1=31;EO2=1"},
    {"home", "", "HOMEX+", "HOME,X,+", "did home X+ switch"},
    {"lhome", "", "LHOMEY-", "LHOME,Y,-", "did home Y- limit"},
    {"zhome", "", "ZHOMEZ+", "ZHOME,Z,+", "did home Z+ switch and index"},
    {"zome", "", "ZOMEU-", "ZOME,U,-", "did home U- index"},
    {"hlhome", "", "HLHOMEX+", "HLHOME,X,+", "did home X+ switch slow"},
    {"jog", "", "JOGX+|JOGY-", "JOG,X,+|JOG,Y,-", "did jog X+;did jog Y-;state0=0"},
    {"joyena", "", "JOYENA=3", "SET,JOYENA,3", "JOYENA=3"},
    {"joyhs", "V1=2", "JOYHSX=10000|JOYHSU=V1", "SET,JOYHSX,10000|SET,JOYHSU,V1", "JOYHSX=10000;JOYHSU=2"},
    {"joydel", "V1=2", "JOYDELX=100|JOYDELU=V1", "SET,JOYDELX,100|SET,JOYDELU,V1", "JOYDELX=100;JOYDELU=2"},
    {"joyno", "V1=2", "JOYNOX=-10000|JOYNOY=V1", "SET,JOYNOX,-10000|SET,JOYNOY,V1", "JOYNOX=-10000;JOYNOY=2"},
    {"joyni", "V1=2", "JOYNIX=-9000|JOYNIY=V1", "SET,JOYNIX,-9000|SET,JOYNIY,V1", "JOYNIX=-9000;JOYNIY=2"},
    {"joypi", "V1=2", "JOYPIX=9000|JOYPIY=V1", "SET,JOYPIX,9000|SET,JOYPIY,V1", "JOYPIX=9000;JOYPIY=2"},
    {"joypo", "V1=2", "JOYPOX=10000|JOYPOY=V1", "SET,JOYPOX,10000|SET,JOYPOY,V1", "JOYPOX=10000;JOYPOY=2"},
    {"mst.get", "MSTX=16", "V1=MSTX&16|IF MSTY=0|V2=1|ENDIF",
     "READ,MSTX|+AND,16,V1|IF,5|+TEST,MSTY,EQ,0,5|SET,V2,1|ENDIF", "V1=16;V2=1"},
    {"p.get", "", "Y12|WAITY|V1=PY", "MOVE,Y,12|WAIT,Y|READ,PY|+PUT,V1", "V1=12"},
    {"p.set", "V1=-5", "PX=300|PZ=V1", "SET,PX,300|SET,PZ,V1", "PX=300;PZ=-5"},
    {"ps.get", "PSX=800", "V1=PSX", "READ,PSX|+PUT,V1", "V1=800"},
    {"scv.get", "SCVX=1", "V1=SCVX", "READ,SCVX|+PUT,V1", "V1=1"},
    {"scv.set", "V1=1", "SCVX=1|SCVY=V1", "SET,SCVX,1|SET,SCVY,V1", "SCVX=1;SCVY=1"},
    {"sl.set", "SLY=1", "SLX=1|SLY=0", "SET,SLX,1|SET,SLY,0", "SLX=1;SLY=0"},
    {"sls.get", "SLSX=9", "IF SLSX!=0|V1=SLSX|ENDIF", "IF,4|+TEST,SLSX,NE,0,4|READ,SLSX|+PUT,V1|ENDIF",
     "V1=9"},
    {"sspd.set", "V1=5", "JOGX+|SSPDX=3000|SSPDY=V1", "JOG,X,+|SET,SSPDX,3000|SET,SSPDY,V1",
     "SSPDX=3000;SSPDY=5;state0=0"},
    {"sspdm.set", "V1=7", "SSPDMX=1|SSPDMU=V1", "SET,SSPDMX,1|SET,SSPDMU,V1", "SSPDMX=1;SSPDMU=7"},
    {"syncfg.set", "V1=3", "SYNCFGX=1|SYNCFGY=V1", "SET,SYNCFGX,1|SET,SYNCFGY,V1", "SYNCFGX=1;SYNCFGY=3"},
    {"synoff", "", "SYNOFFX", "SYNOFF,X", "did sync off X"},
    {"synon", "", "SYNONU", "SYNON,U", "did sync on U"},
    {"synpos.set", "V1=8", "SYNPOSX=3000|SYNPOSEY=V1", "SET,SYNPOSX,3000|SET,SYNPOSY,V1",
     "SYNPOSX=3000;SYNPOSY=8"},
    {"synstat.get", "SYNSTATX=2 SYNSTATY=1", "V1=SYNSTATX|V2=SYNYS",
     "READ,SYNSTATX|+PUT,V1|READ,SYNSTATY|+PUT,V2", "V1=2;V2=1"},
    {"syntime.set", "", "SYNTIMEX=10", "SET,SYNTIMEX,10", "SYNTIMEX=10"},
    {"tr.get", "TR=8001", "IF TR>8000|V1=1|ENDIF", "IF,3|+TEST,TR,GT,8000,3|SET,V1,1|ENDIF", "V1=1"},
    {"tr.set", "", "TR=1000", "SET,TR,1000", "TR=1000"},
    {"move.single", "V10=-12", "X10|WAITX|Y V10|ZV10|U-3", "MOVE,X,10|WAIT,X|MOVE,Y,V10|MOVE,Z,V10|MOVE,U,-3",
     "did move X10;did move Y-12;did move Z-12;did move U-3"},
    {"move.linear", "V1=9", "X20Y30|X1Y2 Z3UV1",
     "MOVE,X,20|+MOVE,Y,30|MOVE,X,1|+MOVE,Y,2|+MOVE,Z,3|+MOVE,U,V1", "did move X20 Y30;did move X1 Y2 Z3 U9"},
    {"wait", "", "X20|WAITX|V1=PX|Y1000|V2=1|WAITY|V2=2",
     "MOVE,X,20|WAIT,X|READ,PX|+PUT,V1|MOVE,Y,1000|SET,V2,1|WAIT,Y|SET,V2,2", "V1=20;V2=1;state0=1"},
};

const std::vector<Case> dmx_cases = {
    {"abortx", "", "JOGX+|ABORTX|WAITX", "JOG,X,+|ABORT,X|WAIT,X", "did abort X;state0=0"},
    {"stopx", "", "JOGX+|STOPX|WAITX", "JOG,X,+|STOP,X|WAIT,X", "did stop X;state0=0"},
    {"drvic.set", "DRVIC=5", "DRVIC=100|DRVIC=0", "SET,DRVIC,100|SET,DRVIC,0", "DRVIC=0"},
    {"drvit.set", "", "DRVIT=1", "SET,DRVIT,1", "DRVIT=1"},
    {"drvrc.set", "", "DRVRC=1000", "SET,DRVRC,1000", "DRVRC=1000"},
    {"eclearx", "", "ECLEARX", "ECLEAR,X", "did clear X"},
    {"ex.get", "EX=-3", "V80=EX", "READ,EX|+PUT,V80", "V80=-3"},
    {"ex.set", "V1=5", "EX=0|EX=V1", "SET,EX,0|SET,EX,V1", "EX=5"},
    {"px.get", "", "X12|WAITX|V1=PX", "MOVE,X,12|WAIT,X|READ,PX|+PUT,V1", "V1=12"},
    {"px.set", "V1=-5", "PX=1|PX=V1", "SET,PX,1|SET,PX,V1", "PX=-5"},
    {"homex", "", "HOMEX+", "HOME,X,+", "did home X+ switch"},
    {"lhomex", "", "LHOMEX-", "LHOME,X,-", "did home X- limit"},
    {"zhomex", "", "ZHOMEX+", "ZHOME,X,+", "did home X+ switch and index"},
    {"zomex", "", "ZOMEX-", "ZOME,X,-", "did home X- index"},
    {"hlhomex", "", "HLHOMEX+", "HLHOME,X,+", "did home X+ switch slow"},
    {"jogx", "", "JOGX-", "JOG,X,-", "did jog X-;state0=0"},
    {"ltx.set", "V1=1", "LTX=0|LTX=V1", "SET,LTX,0|SET,LTX,V1", "LTX=1"},
    {"ltex.get", "LTEX=77", "V3=LTEX", "READ,LTEX|+PUT,V3", "V3=77"},
    {"ltpx.get", "LTPX=78", "V4=LTPX", "READ,LTPX|+PUT,V4", "V4=78"},
    {"ltsx.get", "LTSX=2", "V2=LTSX|IF LTSX=2|V3=1|ENDIF",
     "READ,LTSX|+PUT,V2|IF,5|+TEST,LTSX,EQ,2,5|SET,V3,1|ENDIF", "V2=2;V3=1"},
    {"mstx.get", "MSTX=64", "V1=MSTX", "READ,MSTX|+PUT,V1", "V1=64"},
    {"ps.get", "PS=800", "V1=PS", "READ,PS|+PUT,V1", "V1=800"},
    {"scvx.set", "V1=1", "SCVX=0|SCVX=V1", "SET,SCVX,0|SET,SCVX,V1", "SCVX=1"},
    {"sl.set", "", "SL=0|SLX=1", "SET,SL,0|SET,SL,1", "SL=1"},
    {"slsx.get", "SLSX=8", "IF SLSX!=0|ECLEARX|ENDIF", "IF,3|+TEST,SLSX,NE,0,3|ECLEAR,X|ENDIF",
     "did clear X"},
    {"sspdx.set", "V1=9", "SSPDX=3000|SSPDX=V1", "SET,SSPDX,3000|SET,SSPDX,V1", "SSPDX=9"},
    {"sspdmx.set", "V1=9", "SSPDMX=1|SSPDMX=V1", "SET,SSPDMX,1|SET,SSPDMX,V1", "SSPDMX=9"},
    {"syncfgx.set", "V1=3", "SYNCFGX =1|SYNCFGX=V1", "SET,SYNCFGX,1|SET,SYNCFGX,V1", "SYNCFGX=3"},
    {"synoffx", "", "SYNOFFX", "SYNOFF,X", "did sync off X"},
    {"synonx", "", "SYNONX", "SYNON,X", "did sync on X"},
    {"synposx.set", "V1=8", "SYNPOSX=3000|SYNPOSX=V1", "SET,SYNPOSX,3000|SET,SYNPOSX,V1", "SYNPOSX=8"},
    {"synstatx.get", "SYNSTATX=2", "V1=SYNSTATX|V2=SYNS", "READ,SYNSTATX|+PUT,V1|READ,SYNSTATX|+PUT,V2",
     "V1=2;V2=2"},
    {"waitx", "", "X20|WAITX|V1=PX|X1000|V2=1|WAITX|V2=2",
     "MOVE,X,20|WAIT,X|READ,PX|+PUT,V1|MOVE,X,1000|SET,V2,1|WAIT,X|SET,V2,2", "V1=20;V2=1;state0=1"},
    {"x", "V10=12", "ABS|X-10|WAITX|XV10", "ABS|MOVE,X,-10|WAIT,X|MOVE,X,V10", "did move X-10;did move X12"},
};

std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, by);) parts.push_back(part);
  return parts;
}

/// `|` ends a statement, but for the one that is an operator: a digit follows.
std::string to_text(const std::string& statements) {
  std::string text = statements;
  bool ended = false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '|' && !(i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9')) text[i] = '\n';
  for (const std::string& line : split(text, '\n')) ended |= line == "END";
  return ended ? text : text + "\nEND";
}

void give(Workbench& bench, const std::string& given) {
  for (const std::string& one : split(given, ' ')) {
    const auto equals = one.find('=');
    const int value = std::stoi(one.substr(equals + 1));
    if (one[0] == 'V')
      bench.vm.set_variable(std::stoi(one.substr(1, equals - 1)), value);
    else
      bench.host.set(one.substr(0, equals), value);
  }
}

void expect_effect(Workbench& bench, const std::string& effect) {
  const auto& done = bench.host.done;
  if (effect.starts_with("did ")) {
    EXPECT_NE(std::find(done.begin(), done.end(), effect.substr(4)), done.end()) << effect;
    return;
  }
  const auto equals = effect.find('=');
  const std::string name = effect.substr(0, equals);
  const int value = std::stoi(effect.substr(equals + 1));
  if (name.starts_with("state"))
    EXPECT_EQ(static_cast<int>(bench.vm.state(name.back() - '0')), value) << effect;
  else if (name[0] == 'V')
    EXPECT_EQ(bench.vm.variable(std::stoi(name.substr(1))), value) << effect;
  else
    EXPECT_EQ(bench.host.get(name), value) << effect;
}

struct Language {
  const Dialect& dialect;
  std::string prefix, table;
  const std::vector<Case>& own;
};
const Language languages[] = {{pmx_4ex_sa(), "pmx.sa.", "pmx-4ex-sa-standalone.tsv", pmx_cases},
                              {dmx_k_sa(), "dmx.sa.", "dmx-k-sa-standalone.tsv", dmx_cases}};

/// Rows of a table, by their columns.
std::vector<std::vector<std::string>> rows_of(const Language& language) {
  std::ifstream file(std::string(HW_TEST_DIR) + "/core/devices/arcus/language/" + language.table);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(language.prefix)) rows.push_back(split(line, '\t'));
  return rows;
}

TEST(EveryStatement, HasACaseOfItsOwn) {
  for (const Language& language : languages) {
    std::set<std::string> cases;
    for (const auto* list : {&common_cases, &language.own})
      for (const Case& c : *list) cases.insert(language.prefix + c.id);
    const auto rows = rows_of(language);
    ASSERT_GT(rows.size(), 60U) << language.table;
    std::set<std::string> ids;
    for (const auto& row : rows) ids.insert(row[0]);
    for (const std::string& id : ids) EXPECT_TRUE(cases.count(id)) << id << " has no case";
    for (const std::string& id : cases) EXPECT_TRUE(ids.count(id)) << id << " is in no table";
  }
}

TEST(EveryStatement, CompilesAndActsAsInItsTable) {
  for (const Language& language : languages) {
    for (const auto* list : {&common_cases, &language.own}) {
      for (const Case& c : *list) {
        SCOPED_TRACE(language.prefix + c.id);
        Workbench bench(language.dialect);
        const std::string text = to_text(c.text);
        bench.load(text);
        std::string code = c.code;
        if (text.size() != c.text.size()) code += "|END";
        EXPECT_EQ(bench.compiled.lines, split(code, '|'));
        give(bench, c.given);
        bench.start();
        bench.run_ms(50);
        for (const std::string& effect : split(c.effect, ';')) expect_effect(bench, effect);
      }
    }
  }
}

/// What a table's example needs around it to be a program.
std::string program_around(const std::string& id, const std::string& example) {
  const auto is = [&](const char* what) { return id.ends_with(what); };
  if (is(".comment") || is(".end")) return example + "\n" + (is(".end") ? "" : "END");
  if (is(".prg")) return example + "\nEND";
  if (is(".sub")) return "END\n" + example + "\nENDSUB";
  if (is(".endsub")) return "END\nSUB 1\n" + example;
  if (is(".gosub")) return example + "\nEND\nSUB 1\nENDSUB";
  if (is(".else") || is(".elseif")) return "IF 1=1\n" + example + "\nENDIF\nEND";
  if (is(".endif")) return "IF 1=1\n" + example + "\nEND";
  if (is(".endwhile")) return "WHILE 1=1\n" + example + "\nEND";
  if (example.starts_with("IF ")) return example + "\nENDIF\nEND";
  if (example.starts_with("WHILE ")) return example + "\nENDWHILE\nEND";
  return example + "\nEND";
}

TEST(EveryStatement, ExamplesOfTheTablesCompile) {
  for (const Language& language : languages)
    for (const auto& row : rows_of(language)) {
      const Compilation compiled = compile(program_around(row[0], row[2]), language.dialect);
      EXPECT_TRUE(compiled.ok()) << row[0] << ": " << row[2] << ": "
                                 << (compiled.problems.empty() ? "" : compiled.problems[0].sentence);
    }
}

}  // namespace
}  // namespace hw::arcus::language
