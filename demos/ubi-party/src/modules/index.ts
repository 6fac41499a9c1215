export { PARTY_SET, partyModuleName, partyModules, takesAnswers } from './party-modules.ts';
export type { PhoneDelay, RoundPlan, RoundSeats, RoundState } from './round.ts';
