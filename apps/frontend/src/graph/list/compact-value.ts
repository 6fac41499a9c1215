import type { TopicRecord } from '@ubii/proto';
import { seriesOf } from '../../topics/values/value-series.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';

/** Characters of a value that fit into a row on a phone. */
const MAX_CHARS = 18;
/** Matches numbers separated by commas, without words. */
const NUMBERS = /^[−\de.]+(, [−\de.]+)+$/;

/**
 * Returns the text of a value for a narrow row: numbers that would be cut off get one decimal.
 * @param text of the value in rows of wide pages
 */
export function compactValue(
  { format, value }: Pick<TopicRecord, 'format' | 'value'>,
  text: string,
): string {
  if (text.length <= MAX_CHARS || !NUMBERS.test(text)) return text;
  const numbers = seriesOf(format)?.read(value as never);
  return numbers?.map((number) => formatNumber(number, 1)).join(' ') ?? text;
}
