#include "checks.H"
void Foam::operatorChecks(tally&){}
void Foam::symmetryChecks(tally&){}
void Foam::precisionChecks(tally&){}
