// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, nextTick, shallowRef } from 'vue';
import type { GraphEditor } from '../editing/graph-editor.ts';
import { useRoom, type Room } from './useRoom.ts';

let widthPx = 0;
const lists = new Set<() => void>();

/** As a window of this width answers, and tells when that changes. */
function match(query: string) {
  const most = /max-width: (\d+)px/.exec(query)?.[1];
  const least = /min-width: (\d+)px/.exec(query)?.[1];
  return {
    get matches() {
      return widthPx <= Number(most ?? Infinity) && widthPx >= Number(least ?? 0);
    },
    addEventListener: (_: string, handle: (event: { matches: boolean }) => void) =>
      lists.add(() => handle(match(query))),
    removeEventListener: () => undefined,
  };
}

async function resize(px: number): Promise<void> {
  widthPx = px;
  for (const tell of lists) tell();
  await nextTick();
}

function open(): Room {
  const selection = shallowRef({ nodes: new Set(), wire: undefined });
  const editor = { selection } as unknown as GraphEditor;
  let room!: Room;
  const setup = () => {
    room = useRoom(editor);
    return () => h('p');
  };
  mount(defineComponent({ setup }));
  return room;
}

beforeEach(() => vi.stubGlobal('matchMedia', match));
afterEach(() => {
  lists.clear();
  vi.unstubAllGlobals();
});

describe('a graph in a window', () => {
  it('is a list where it is narrow, and a graph again when it grows', async () => {
    await resize(1440);
    const { view } = open();
    expect(view.value).toBe('graph');
    await resize(500);
    expect(view.value).toBe('list');
    await resize(1440);
    expect(view.value).toBe('graph');
  });

  it('stays what was chosen while the window keeps its kind', async () => {
    await resize(1440);
    const { view } = open();
    view.value = 'list';
    await resize(1300);
    expect(view.value).toBe('list');
  });
});
