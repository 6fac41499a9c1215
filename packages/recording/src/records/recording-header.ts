const KINDS = ['recording', 'flight-recorder', 'import', 'comparison'] as const;

/** Where a recording comes from. */
export type RecordingKind = (typeof KINDS)[number];

/** The metadata record `ubi-interact` of a file. The last one of a file is valid. */
export interface RecordingHeader {
  readonly name: string;
  readonly kind: RecordingKind;
  readonly masterName: string;
  /** Version of the program that wrote the file. */
  readonly version: string;
  readonly notes: string;
  /** The selection of topics, as JSON. */
  readonly selection: string;
  /** `ubii.extension.PersonalData` as JSON: the labels of personal data when it was recorded. @default none */
  readonly personalData?: string;
}

/** Name of the metadata record, and profile of the file. */
export const PROFILE = 'ubi-interact';

/** The header as a metadata record has it. */
export function headerToMetadata(header: RecordingHeader): Map<string, string> {
  return new Map(Object.entries(header));
}

/** The header of a metadata record; what is missing is empty. */
export function headerFromMetadata(metadata: ReadonlyMap<string, string>): RecordingHeader {
  const text = (key: string): string => metadata.get(key) ?? '';
  const personalData = text('personalData');
  return {
    name: text('name'),
    kind: kindOf(text('kind')),
    masterName: text('masterName'),
    version: text('version'),
    notes: text('notes'),
    selection: text('selection'),
    ...(personalData !== '' && { personalData }),
  };
}

function kindOf(text: string): RecordingKind {
  return KINDS.find((kind) => kind === text) ?? 'import';
}
