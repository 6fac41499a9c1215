import { describe, expect, it } from 'vitest';
import {
  applyChange,
  copyOf,
  inverseOf,
  nameOf,
  theirsOf,
  withEnabled,
  type MappingChange,
} from './mapping-changes.ts';

const lamps = { direction: 'out', foreign: 'lamps/{1}', topic: '/lamps/*' };
const heat = { name: 'heat', direction: 'in', foreign: 'heat', topic: '/heat', format: 'double' };
const LIST = [lamps, heat];

describe('change of a mapping', () => {
  it.each<MappingChange>([
    { kind: 'add', mapping: { ...heat, name: 'new' }, index: 1 },
    { kind: 'replace', before: heat, mapping: { ...heat, topic: '/hot' }, index: 1 },
    { kind: 'remove', before: lamps, index: 0 },
  ])('$kind is taken back by its inverse', (change) => {
    const changed = applyChange(LIST, change)!;
    expect(changed.list).not.toEqual(LIST);
    expect(applyChange(changed.list, inverseOf(change, changed.index))?.list).toEqual(LIST);
  });

  it('finds the mapping where others moved it to [BR-82]', () => {
    const moved = [heat, lamps];
    expect(applyChange(moved, { kind: 'remove', before: heat, index: 1 })?.list).toEqual([lamps]);
  });

  it('is none of a mapping that others changed or removed [BR-82]', () => {
    const theirs = { ...heat, topic: '/theirs' };
    const change = { kind: 'replace', before: heat, mapping: heat, index: 1 } as const;
    expect(applyChange([lamps, theirs], change)).toBeUndefined();
    expect(theirsOf([lamps, theirs], heat)).toEqual(theirs);
    expect(theirsOf([lamps], heat)).toBeUndefined();
  });
});

describe('mapping', () => {
  it('without a name has the one that the bridge makes of both sides', () => {
    expect(nameOf(lamps)).toBe('lamps/{1} out /lamps/*');
    expect(nameOf(heat)).toBe('heat');
  });

  it('that is on has no member for that [BR-5]', () => {
    expect(withEnabled(heat, false)).toEqual({ ...heat, enabled: false });
    expect(withEnabled({ ...heat, enabled: false }, true)).toEqual(heat);
  });

  it('is copied under a name of its own', () => {
    const first = copyOf(heat, LIST);
    expect(first).toMatchObject({ name: 'heat copy', topic: '/heat' });
    expect(copyOf(heat, [...LIST, first])).toMatchObject({ name: 'heat copy 2' });
  });
});
