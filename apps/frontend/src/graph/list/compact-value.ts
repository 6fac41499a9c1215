import type { TopicRecord } from '@ubii/proto';
import { seriesOf } from '../../topics/values/value-series.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';

/** Characters that a row of a phone has for a value. */
const MAX_CHARS = 18;
/** Numbers with commas between them, and no words. */
const NUMBERS = /^[−\de.]+(, [−\de.]+)+$/;

/**
 * The text of a value for a narrow row: numbers that would be cut off have one decimal.
 * @param text of the value as rows of wide pages show it
 */
export function compactValue(
  { format, value }: Pick<TopicRecord, 'format' | 'value'>,
  text: string,
): string {
  if (text.length <= MAX_CHARS || !NUMBERS.test(text)) return text;
  const numbers = seriesOf(format)?.read(value as never);
  return numbers?.map((number) => formatNumber(number, 1)).join(' ') ?? text;
}
