import type { Mark } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { Marks, placeOf } from './marks.ts';

const CORAL_CIRCLE: Mark = { shape: 1, colour: 1, chosen: false };

describe('marks [EX-100]', () => {
  it('gives everybody another shape and colour, while there are any', () => {
    const marks = new Marks();
    const given = Array.from({ length: 8 }, () => {
      const mark = marks.free();
      marks.count(mark, 1);
      return mark;
    });
    expect(new Set(given.map(({ shape }) => shape)).size).toBe(8);
    expect(new Set(given.map(({ colour }) => colour)).size).toBe(8);
  });

  it('gives each pair once before one is given twice', () => {
    const marks = new Marks();
    const places = Array.from({ length: 144 }, () => {
      const mark = marks.free();
      marks.count(mark, 1);
      return placeOf(mark);
    });
    expect(new Set(places).size).toBe(144);
    expect(marks.free()).toBeDefined();
  });

  it('keeps a proposal only while no client has it, and a choice always', () => {
    const marks = new Marks();
    expect(marks.decide(CORAL_CIRCLE, undefined)).toEqual(CORAL_CIRCLE);
    marks.count(CORAL_CIRCLE, 1);
    expect(marks.decide(CORAL_CIRCLE, undefined)).toMatchObject({ shape: 2, colour: 2 });
    const chosen = { ...CORAL_CIRCLE, chosen: true };
    expect(marks.decide(chosen, undefined)).toEqual(chosen);
  });

  it('ignores what is no mark', () => {
    const marks = new Marks();
    const wrong = { shape: 99, colour: 1, chosen: true } as unknown as Mark;
    expect(marks.decide(wrong, undefined)).toEqual(CORAL_CIRCLE);
  });

  it('is free again when its client is gone', () => {
    const marks = new Marks();
    marks.count(CORAL_CIRCLE, 1);
    marks.count(CORAL_CIRCLE, -1);
    expect(marks.free()).toEqual(CORAL_CIRCLE);
  });
});
