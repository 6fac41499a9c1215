export { PARTY_SET, partyModuleName, partyModules } from './party-modules.ts';
export type { RoundPlan, RoundSeats, RoundState } from './round.ts';
