import { fromJson, type JsonObject, type PersonalLabel, type TextLimits } from '@ubii/proto';
import { hasMoreCharacters, isLongerThan } from '@ubii/words';
import { RecordingError } from './recording-error.ts';

/**
 * Checks the labels of personal data in the header of a file: one that is cut or left out would protect nothing.
 *
 * @throws RecordingError when they cannot be read, or there are too many or too long ones [RC-54]
 */
export function checkLabels(personalData: string | undefined, limits: TextLimits): void {
  if (personalData === undefined) return;
  const labels = parseLabels(personalData);
  const { personalLabels } = limits;
  if (labels.length > personalLabels) {
    throw new RecordingError(
      `It has ${labels.length} labels of personal data, and a recording has at most ${personalLabels}.`,
    );
  }
  const place = labels.findIndex((label) => isTooLong(label, limits)) + 1;
  if (place > 0) throw new RecordingError(`Its label ${place} of personal data is too long.`);
}

function parseLabels(personalData: string): readonly PersonalLabel[] {
  try {
    return fromJson('ubii.extension.PersonalData', JSON.parse(personalData) as JsonObject).labels;
  } catch (cause) {
    throw new RecordingError('Its labels of personal data cannot be read.', { cause });
  }
}

function isTooLong(
  { id, topicPattern, fieldPath, note }: PersonalLabel,
  { idCharacters, topicBytes, identifierCharacters, descriptionCharacters }: TextLimits,
): boolean {
  return (
    hasMoreCharacters(id, idCharacters) ||
    isLongerThan(topicPattern, topicBytes) ||
    hasMoreCharacters(fieldPath, identifierCharacters) ||
    hasMoreCharacters(note, descriptionCharacters)
  );
}
