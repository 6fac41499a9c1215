export type { Treatment } from './treatment.ts';
export { createTreatment } from './create-treatment.ts';
export { findPeople, type KnownPeople } from './known-people.ts';
export { isTreatable, parseFieldPath, VALUE_FIELDS } from './labels.ts';
export { labelsOf, parsePersonalRules } from './parse-rules.ts';
export { SHARING_RULES, type PersonalRules } from './personal-rules.ts';
export { Pseudonyms } from './pseudonyms.ts';
export {
  createPseudonymKey,
  formatPseudonymKey,
  parsePseudonymKey,
  type PseudonymKey,
} from './pseudonym-key.ts';
export { leftOutParts } from './left-out-parts.ts';
export { TreatedReader } from './treated-reader.ts';
export { treatRecording } from './treat-recording.ts';
