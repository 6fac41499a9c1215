import { capitalised } from '@ubii/words';

/**
 * The label of a name: its letters and digits (ASCII), each word after the first with a capital. [ST-13]
 * @returns an empty text when there are none
 */
export function labelOf(name: string): string {
  return name
    .split(/[^A-Za-z0-9]+/)
    .filter(Boolean)
    .map((word, index) => (index === 0 ? word : capitalised(word)))
    .join('');
}

/** A number as a label: two digits at least. [ST-13] */
export function labelOfNumber(number: number): string {
  return String(number).padStart(2, '0');
}
