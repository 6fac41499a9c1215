import { describe, expect, it } from 'vitest';
import { saidByHeading } from './path-words.ts';

describe('saidByHeading', () => {
  it('leaves out a path that the heading repeats', () => {
    const path = { parent: undefined, here: 'Examples' };
    expect(saidByHeading(path, 'Examples')).toEqual({ parent: false, here: true });
  });

  it('keeps the way up of a page that has its own name as its heading', () => {
    const path = { parent: 'Learn', here: 'Data formats' };
    expect(saidByHeading(path, 'Data formats')).toEqual({ parent: false, here: true });
  });

  it('leaves out what stands beside the list with that heading', () => {
    const path = { parent: 'Modules', here: 'clock' };
    expect(saidByHeading(path, 'Modules')).toEqual({ parent: true, here: true });
  });

  it('keeps the whole path of a page without a name as its heading', () => {
    const path = { parent: 'Sessions', here: 'Sine wave' };
    expect(saidByHeading(path, undefined)).toEqual({ parent: false, here: false });
  });
});
