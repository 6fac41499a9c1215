import { PersonalTreatment, type PersonalLabel } from '@ubii/proto';
import { isTreatable, parseFieldPath } from '@ubii/recording/personal';
import { quote } from '../texts/quote.ts';

const WORDS = new Map<PersonalTreatment, string>([
  [PersonalTreatment.PERSONAL_TREATMENT_DROP, 'dropped'],
  [PersonalTreatment.PERSONAL_TREATMENT_PSEUDONYM, 'replaced by pseudonyms'],
  [PersonalTreatment.PERSONAL_TREATMENT_ROUND, 'rounded'],
]);

/** What is wrong with a label, to be read after "The label is refused:"; undefined when nothing is. [PD-2] */
export function checkLabel({
  topicPattern,
  fieldPath,
  treatment,
  step,
}: PersonalLabel): string | undefined {
  if (!/^[/*]/.test(topicPattern)) {
    return `the pattern ${quote(topicPattern)} names no topics. Patterns begin with "/" or "*"`;
  }
  const path = parseFieldPath(fieldPath);
  if (path === undefined) {
    return `no data format has the member ${quote(fieldPath)}. Use a path such as "object2DList.elements.id"`;
  }
  const word = WORDS.get(treatment);
  if (word === undefined) return `the treatment ${treatment} is unknown`;
  const member = path.at(-1);
  if (member !== undefined && !isTreatable(member, treatment)) {
    return `values of ${quote(fieldPath)} cannot be ${word}`;
  }
  return step >= 0 && Number.isFinite(step) ? undefined : `the step ${step} is no number from 0 on`;
}
