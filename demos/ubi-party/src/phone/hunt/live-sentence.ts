import { thingOf, type Question } from '../../sim/index.ts';
import type { Sighting } from './detector/detector.ts';

/** Sentence for the current detection, shown before the player presses. */
export function liveSentence(question: Question, seen: Sighting | undefined): string {
  const { text, name } = question;
  if (seen === undefined) return `Looking for ${name}`;
  if (seen.label === text)
    return text === 'scissors' ? 'Scissors. Take it!' : `That’s ${name}. Take it!`;
  return `That’s ${thingOf(seen.label).name}, not ${name}`;
}
