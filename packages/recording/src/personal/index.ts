export { createTreatment, type Treatment } from './create-treatment.ts';
export { findPeople, type KnownPeople } from './known-people.ts';
export { isTreatable, parseFieldPath, VALUE_FIELDS } from './labels.ts';
export {
  labelsOf,
  parsePersonalRules,
  SHARING_RULES,
  type PersonalRules,
} from './personal-rules.ts';
export {
  Pseudonyms,
  createPseudonymKey,
  formatPseudonymKey,
  parsePseudonymKey,
  type PseudonymKey,
} from './pseudonyms.ts';
export { leftOutParts } from './treatment-report.ts';
export { TreatedReader, treatRecording } from './treated-reader.ts';
