// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { LESSONS } from '../lessons/lessons.ts';
import type { Lesson } from '../model/lesson.ts';
import LessonText from './LessonText.vue';

const lessonOf = (kind: Lesson['workspace']['kind']): Lesson =>
  LESSONS.find(({ workspace }) => workspace.kind === kind)!;

function show(lesson: Lesson, step: number, isDone = false) {
  const checks = lesson.steps[step]?.checks ?? [];
  const passed = new Map(isDone ? checks.map(({ id }) => [id, ''] as const) : []);
  const wrapper = mount(LessonText, {
    props: {
      lesson,
      number: 1,
      total: LESSONS.length,
      run: { step, reached: lesson.steps.length - 1, passed, isDone },
      found: new Map(),
      next: undefined,
      busy: undefined,
    },
    global: { stubs: { RouterLink: true } },
  });
  const bar = wrapper.get('.progress span').element as HTMLElement;
  return { text: wrapper.text(), width: bar.style.width };
}

describe('the text of a lesson', () => {
  it('names what is kept, and Save, only where there is something to keep', () => {
    const topic = lessonOf('topic');
    expect(show(topic, topic.steps.length - 1, true).text).not.toContain('Save');
    const graph = lessonOf('graph');
    expect(show(graph, graph.steps.length - 1, true).text).toContain('press Save to keep it');
  });

  it('counts the steps that are done', () => {
    const { steps } = lessonOf('graph');
    expect(show(lessonOf('graph'), 0).width).toBe('0%');
    expect(show(lessonOf('graph'), steps.length - 1).width).not.toBe('100%');
    expect(show(lessonOf('graph'), steps.length - 1, true).width).toBe('100%');
  });

  it('a finished lesson that is opened again needs no more time', () => {
    expect(show(lessonOf('graph'), 0, true).text).not.toContain('min left');
    expect(show(lessonOf('graph'), 0).text).toContain('min left');
  });
});
