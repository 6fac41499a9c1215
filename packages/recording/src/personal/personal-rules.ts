import type { PersonalLabel } from '@ubii/proto';

/** What is replaced or dropped when a recording is shared. */
export interface PersonalRules {
  /** Values in topics; later ones apply to what earlier ones left. */
  readonly labels: readonly PersonalLabel[];
  /** Ids and names of clients, and names of devices and authors, wherever they are found. */
  readonly clients: 'pseudonym' | 'keep';
  /** Name and notes of the recording. */
  readonly notes: 'drop' | 'keep';
  /** Texts of markers; names of clients in them are replaced. */
  readonly markerTexts: 'drop' | 'keep';
  /** Shift moves all absolute times by the offset of the key. */
  readonly time: 'keep' | 'shift';
}

/** Rules of a recording that is shared, without labels. */
export const SHARING_RULES: PersonalRules = {
  labels: [],
  clients: 'pseudonym',
  notes: 'drop',
  markerTexts: 'keep',
  time: 'keep',
};
