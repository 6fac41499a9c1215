import { ServiceError, type Study, type StudyDevice } from '@ubii/proto';
import { labelOf, NameTemplate } from '@ubii/recording/studies';

/** What is wrong with a study, by the field that says it. */
export type StudyErrors = Readonly<Record<string, string>>;

/** What can be seen before the master is asked; the master checks the same and more. */
export function studyErrors(study: Study): StudyErrors {
  const errors: Record<string, string> = {};
  const put = (field: string, error: string | undefined): void => {
    if (error !== undefined) errors[field] = error;
  };
  put('name', study.name.trim() === '' ? 'Enter a name.' : undefined);
  put('template', templateError(study.nameTemplate));
  put('repetitions', rangeError(study.repetitions, 1, 200));
  const { conditions } = study;
  if (conditions.length === 0) put('conditions', 'Add at least one condition.');
  const labels = conditions.map(({ name }) => labelOf(name).toLowerCase());
  labels.forEach((label, index) => put(`condition ${index}`, labelError(label, labels, index)));
  study.devices.forEach((device, index) => put(`device ${index}`, deviceError(device)));
  if (study.repetitions * conditions.length > MAX_BLOCKS)
    put('repetitions', `A run has at most ${MAX_BLOCKS} blocks.`);
  return errors;
}

const MAX_BLOCKS = 200;

function templateError(template: string): string | undefined {
  try {
    new NameTemplate(template);
    return undefined;
  } catch (cause) {
    if (!(cause instanceof ServiceError)) throw cause;
    return cause.message;
  }
}

function labelError(label: string, all: readonly string[], index: number): string | undefined {
  if (label === '') return 'Enter a name with letters or digits.';
  if (all.indexOf(label) === index) return undefined;
  return 'Another condition has the same letters and digits. Choose another name.';
}

function rangeError(value: number, from: number, until: number): string | undefined {
  const isFine = Number.isInteger(value) && value >= from && value <= until;
  return isFine ? undefined : `Enter a whole number from ${from} to ${until}.`;
}

function deviceError(device: StudyDevice): string | undefined {
  if (device.name.trim() === '') return 'Enter a name for the device.';
  const { topicPattern, dataFormat, tag } = device;
  if (topicPattern === '' && dataFormat === '' && tag === '')
    return 'Choose what identifies the device.';
  return undefined;
}
