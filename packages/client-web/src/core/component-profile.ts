import type { DataFormat } from '@ubii/proto';

/** Describes components by what they have in common. A component matches when every member given matches. */
export interface ComponentProfile {
  readonly id?: string;
  readonly name?: string;
  /** Data format of its records, or the message format as it was registered. */
  readonly format?: DataFormat | (string & {});
  readonly deviceId?: string;
  /** Tags it has, all of them. */
  readonly tags?: readonly string[];
}
