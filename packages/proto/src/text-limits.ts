/**
 * Limits of texts and of lists of texts in messages, by the names that they have on a master, where each has its reason. What reads
 * texts of files has the same ones. [EX-70] [RC-54]
 */
export const DEFAULT_TEXT_LIMITS = {
  idCharacters: 256,
  identifierCharacters: 256,
  nameCharacters: 100,
  descriptionCharacters: 4_096,
  eventCharacters: 500,
  topicBytes: 1_024,
  textsPerList: 256,
  personalLabels: 200,
} as const;

/** Values of these limits. */
export type TextLimits = { readonly [L in keyof typeof DEFAULT_TEXT_LIMITS]: number };
