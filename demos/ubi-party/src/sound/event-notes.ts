import { pitchOf, scalePitch, type Note, type Voice } from './note.ts';
import type { SoundEvent } from './sound-events.ts';

interface LaterNote extends Note {
  readonly afterS: number;
}

/** The notes of a sound event. */
export function notesOf(event: SoundEvent): LaterNote[] {
  switch (event.kind) {
    case 'join':
      return [
        note('knock', pitchOf(event.seat), 0.8),
        note('knock', pitchOf(event.seat), 0.35, 0.16),
      ];
    case 'leave':
      return [note('knock', pitchOf(event.seat) - 12, 0.4)];
    case 'ready':
      return [note('mallet', pitchOf(event.seat), 0.35)];
    case 'hit':
      return [note('knock', pitchOf(event.seat), 0.55)];
    case 'press':
      return [note('block', pitchOf(event.seat), 0.5)];
    case 'land':
      return [note('knock', pitchOf(event.seat) - 12, 0.4)];
    case 'news':
      return [note('mallet', pitchOf(event.seat), 0.6), note('knock', pitchOf(event.seat), 0.3)];
    case 'crown':
      return run('marimba', pitchOf(event.seat), [0, 2], 0.09, 0.45);
    case 'boost':
      return run('marble', pitchOf(event.seat) + 12, [0, 1, 2, 3, 4, 5], 0.035, 0.4);
    case 'fall':
      return [
        ...run('marble', pitchOf(event.seat), [4, 3, 2, 1, 0], 0.06, 0.35),
        note('drum', 40, 0.5, 0.36),
      ];
    case 'flourish':
      return run('marimba', pitchOf(event.seat), [0, 2, 4, 5, 7, 10], 0.1, 0.75);
    case 'count':
      return [note('block', 76, 0.8)];
    case 'go':
      return [note('block', 88, 0.9), note('marimba', 72, 0.5)];
    case 'tick':
      return [note('block', event.left <= 3 ? 74 : 67, event.left <= 3 ? 0.55 : 0.16)];
    case 'ring':
      return [note('knock', 43, 0.9), note('drum', 33, 0.7, 0.05), note('knock', 38, 0.6, 0.24)];
    case 'flag':
      return [note('drum', 41, 1)];
    case 'question':
      return run('mallet', 60, [0, 3], 0.14, 0.5);
  }
}

function note(voice: Voice, midi: number, strength: number, afterS = 0): LaterNote {
  return { voice, midi, strength, afterS };
}

/** One after the other on the scale above a root. */
function run(
  voice: Voice,
  root: number,
  degrees: readonly number[],
  everyS: number,
  strength: number,
): LaterNote[] {
  return degrees.map((degree, index) =>
    note(voice, scalePitch(root, degree), strength, index * everyS),
  );
}
