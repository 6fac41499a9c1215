import type { EventsReader } from '@ubii/recording';
import {
  createPseudonymKey,
  createTreatment,
  findPeople,
  formatPseudonymKey,
  leftOutParts,
  parsePseudonymKey,
  Pseudonyms,
  TreatedReader,
} from '@ubii/recording/personal';
import type { PersonalChoice } from './personal-choice.ts';

/** A recording as it is exported with personal data replaced. */
export interface SharedRecording {
  readonly reader: EventsReader;
  /** Returns a topic as it is exported; undefined when it is dropped. */
  topic(topic: string): string | undefined;
  /** What a copy does not have because it cannot be searched for names, as sentences without their ends. [PD-14] */
  readonly leftOut: readonly string[];
  /** What was found of labelled values in what was read so far, as sentences without their ends. [PD-18] */
  report(): readonly string[];
  /** Content of the key file, with the pseudonyms given so far. */
  key(): string;
}

/** @throws RecordingError when the key file is none */
export async function shareReader(
  reader: EventsReader,
  { rules, key }: PersonalChoice,
): Promise<SharedRecording> {
  const pseudonyms = new Pseudonyms(
    key === undefined
      ? createPseudonymKey((bytes) => crypto.getRandomValues(bytes))
      : parsePseudonymKey(key),
  );
  const treatment = createTreatment(rules, await findPeople(reader, rules.labels), pseudonyms);
  const parts = leftOutParts(reader.summary);
  return {
    leftOut: parts === '' ? [] : [`Left out: ${parts}`],
    reader: new TreatedReader(reader, treatment),
    topic: (topic) => treatment.topic(topic),
    report: () => treatment.report(),
    key: () => formatPseudonymKey(pseudonyms.key),
  };
}
