import type { Recording } from '@ubii/proto';

/** The name without the participant of a study: everybody reads the status, and names of clients are recorded and logged. [ST-52] */
export function publicName({ name, study }: Recording): string {
  return study === undefined ? name : `${study.studyName}, block ${study.block}`;
}
