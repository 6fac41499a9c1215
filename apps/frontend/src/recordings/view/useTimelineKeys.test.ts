// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h } from 'vue';
import type { Timeline } from './useTimeline.ts';
import { useTimelineKeys } from './useTimelineKeys.ts';

function setUp() {
  const opened = { togglePlay: vi.fn(), stepRecord: vi.fn(), stepTime: vi.fn() };
  const tracks = [
    { topic: '/a', kind: 'lines' },
    { topic: '/image', kind: 'frames' },
  ];
  const timeline = {
    opened,
    selected: { value: tracks[0] },
    shown: { value: tracks },
    setLoopEdge: vi.fn(),
    fit: vi.fn(),
  };
  const mark = vi.fn();
  const page = defineComponent(() => {
    useTimelineKeys(timeline as unknown as Timeline, mark);
    return () => h('div', [h('input'), h('button', 'Play'), h('a', { href: '#' }, 'Study')]);
  });
  const wrapper = mount(page, { attachTo: document.body });
  wrappers.push(wrapper);
  const press = (key: string, init: KeyboardEventInit = {}, at: Element = document.body): void =>
    void at.dispatchEvent(
      new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true, ...init }),
    );
  return { opened, timeline, mark, press, wrapper };
}
const wrappers: { unmount(): void }[] = [];
afterEach(() => wrappers.splice(0).forEach((wrapper) => wrapper.unmount()));

describe('keys of the timeline', () => {
  it('play, mark, loop and fit', () => {
    const { opened, timeline, mark, press } = setUp();
    for (const key of [' ', 'm', 'i', 'O', '0']) press(key);
    expect(opened.togglePlay).toHaveBeenCalledOnce();
    expect(mark).toHaveBeenCalledOnce();
    expect(timeline.setLoopEdge.mock.calls).toEqual([['from'], ['until']]);
    expect(timeline.fit).toHaveBeenCalledOnce();
  });

  it('step by records of the selected track, by pictures and by seconds', () => {
    const { opened, press } = setUp();
    press('ArrowRight');
    press(',');
    press('ArrowLeft', { shiftKey: true });
    expect(opened.stepRecord.mock.calls).toEqual([
      ['/a', 1],
      ['/image', -1],
    ]);
    expect(opened.stepTime.mock.calls).toEqual([[-1000]]);
  });

  it('work while the link has the focus that opened the recording', () => {
    const { opened, press, wrapper } = setUp();
    press(' ', {}, wrapper.find('a').element);
    expect(opened.togglePlay).toHaveBeenCalledOnce();
  });

  it('are left to fields, and Space to buttons', () => {
    const { opened, mark, press, wrapper } = setUp();
    press('m', {}, wrapper.find('input').element);
    press(' ', {}, wrapper.find('button').element);
    expect(mark).not.toHaveBeenCalled();
    expect(opened.togglePlay).not.toHaveBeenCalled();
  });
});
