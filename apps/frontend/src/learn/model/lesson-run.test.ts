import { describe, expect, it } from 'vitest';
import { LESSONS } from '../lessons/lessons.ts';
import { NO_FACTS } from './facts.ts';
import { hasPassed, measureStep, nextRun, startLesson, type LessonRun } from './lesson-run.ts';
import type { Lesson, Measurement } from './lesson.ts';

const check = (id: string) => ({
  id,
  text: id,
  todo: id,
  measure: ({ ownId }: { readonly ownId: string }): Measurement => ({
    passed: ownId.includes(id),
    value: ownId,
  }),
});
const answer = { kind: 'try-run' } as const;
const lesson: Lesson = {
  id: 'test',
  title: 'Test',
  heading: 'Test',
  intro: '',
  minutes: 1,
  workspace: { kind: 'topic' },
  steps: [
    { title: 'one', text: '', checks: [check('a'), check('b')], answer },
    { title: 'two', text: '', checks: [check('c')], answer },
  ],
};
const observe = (run: LessonRun, ownId: string): LessonRun =>
  nextRun(lesson, run, {
    kind: 'observe',
    found: measureStep(lesson, run.step, { ...NO_FACTS, ownId }),
  });

describe('a lesson', () => {
  it('keeps what a check measured when it passed', () => {
    const run = observe(observe(startLesson(lesson), 'a'), 'b');
    expect([...run.passed]).toEqual([
      ['a', 'a'],
      ['b', 'b'],
    ]);
    expect(hasPassed(lesson, run)).toBe(true);
  });

  it('stays at a step until all of its checks have passed', () => {
    const run = observe(startLesson(lesson), 'a');
    expect(nextRun(lesson, run, { kind: 'next' })).toBe(run);
    expect(nextRun(lesson, observe(run, 'b'), { kind: 'next' })).toMatchObject({
      step: 1,
      reached: 1,
      isDone: false,
    });
  });

  it('is done after its last step, and starts over from the first', () => {
    let run = nextRun(lesson, observe(startLesson(lesson), 'ab'), { kind: 'next' });
    run = nextRun(lesson, observe(run, 'c'), { kind: 'next' });
    expect(run).toMatchObject({ step: 1, isDone: true });
    expect(nextRun(lesson, run, { kind: 'restart' })).toEqual(startLesson(lesson));
  });

  it('forgets what passed when its step is reset', () => {
    const run = nextRun(lesson, observe(startLesson(lesson), 'ab'), { kind: 'reset' });
    expect(run.passed.size).toBe(0);
    expect(run.step).toBe(0);
  });

  it('opens only steps that were reached', () => {
    const run = startLesson(lesson);
    expect(nextRun(lesson, run, { kind: 'open', step: 1 })).toBe(run);
    const farther = nextRun(lesson, observe(run, 'ab'), { kind: 'next' });
    expect(nextRun(lesson, farther, { kind: 'open', step: 0 })).toMatchObject({
      step: 0,
      reached: 1,
    });
  });

  it('starts where it was left, and at its first step once it is done', () => {
    expect(startLesson(lesson, { reached: 1, isDone: false }).step).toBe(1);
    expect(startLesson(lesson, { reached: 99, isDone: false }).step).toBe(1);
    expect(startLesson(lesson, { reached: 1, isDone: true }).step).toBe(0);
  });
});

describe.each(LESSONS.map((one) => [one.id, one] as const))('the lesson %s', (_id, one) => {
  it('takes five minutes and five steps at most', () => {
    expect(one.minutes).toBeLessThanOrEqual(5);
    expect(one.steps.length).toBeLessThanOrEqual(5);
  });

  it.each(one.steps.map((step) => [step.title, step] as const))(
    'says "%s" in 60 words at most and checks it',
    (_title, step) => {
      expect(step.text.split(/\s+/).length).toBeLessThanOrEqual(60);
      expect(step.checks.length).toBeGreaterThan(0);
      expect(new Set(step.checks.map(({ id }) => id)).size).toBe(step.checks.length);
    },
  );

  it('passes nothing while nothing runs', () => {
    for (const step of one.steps.slice(0, -1)) {
      for (const { measure } of step.checks) expect(measure(NO_FACTS).passed).toBe(false);
    }
  });
});
