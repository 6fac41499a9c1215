// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { ref } from 'vue';
import type { Span } from '../timeline/span.ts';
import SpanEdge from './SpanEdge.vue';
import { TIMELINE } from './useTimeline.ts';

const setUp = (edge: 'from' | 'until') => {
  const loop = ref<Span>({ fromMs: 200, untilMs: 400 });
  const timeline = {
    loop,
    span: ref<Span>({ fromMs: 0, untilMs: 1000 }),
    durationMs: ref(1000),
    setLoop: (span: Span) => (loop.value = span),
  };
  const wrapper = mount(SpanEdge, {
    props: { edge, timeOf: ({ clientX }: { readonly clientX: number }) => clientX },
    global: { provide: { [TIMELINE as symbol]: timeline } },
  });
  wrapper.element.setPointerCapture = () => undefined;
  return { loop, wrapper };
};

describe('an edge of the span', () => {
  it('is dragged, also past the other edge', async () => {
    const { loop, wrapper } = setUp('from');
    await wrapper.trigger('pointerdown', { button: 0, clientX: 200 });
    await wrapper.trigger('pointermove', { clientX: 300 });
    expect(loop.value).toEqual({ fromMs: 300, untilMs: 400 });
    await wrapper.trigger('pointermove', { clientX: 401 });
    expect(loop.value).toEqual({ fromMs: 300, untilMs: 400 });
    await wrapper.trigger('pointermove', { clientX: 600 });
    await wrapper.trigger('pointerup', { clientX: 600 });
    await wrapper.trigger('pointermove', { clientX: 700 });
    expect(loop.value).toEqual({ fromMs: 400, untilMs: 600 });
  });

  it('is moved by keys', async () => {
    const { loop, wrapper } = setUp('until');
    await wrapper.trigger('keydown', { key: 'ArrowRight' });
    await wrapper.trigger('keydown', { key: 'ArrowLeft', shiftKey: true });
    expect(loop.value).toEqual({ fromMs: 200, untilMs: 355 });
    expect(wrapper.attributes('aria-valuetext')).toBe('0:00.355');
  });
});
