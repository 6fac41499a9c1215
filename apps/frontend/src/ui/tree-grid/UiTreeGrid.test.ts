// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { h, nextTick } from 'vue';
import type { TreeGridRow } from './tree-grid-row.ts';
import UiTreeGrid from './UiTreeGrid.vue';

const ROW_PIXELS = 20;
const SHOWN_ROWS = 5;

const rowsOf = (...keys: readonly string[]): TreeGridRow[] =>
  keys.map((key, index) => ({ key, level: 1, position: index + 1, setSize: keys.length }));
const many = rowsOf(...Array.from({ length: 100 }, (_, index) => `row ${index}`), 'last');

beforeEach(() => {
  const pixels = ROW_PIXELS * SHOWN_ROWS;
  vi.spyOn(HTMLElement.prototype, 'clientHeight', 'get').mockReturnValue(pixels);
});
afterEach(() => vi.restoreAllMocks());

async function mounted(rows: readonly TreeGridRow[], selected?: string) {
  const grid = mount(UiTreeGrid<TreeGridRow>, {
    attachTo: document.body,
    props: {
      label: 'Things',
      rows,
      selected,
      selectable: true,
      sizeOf: () => ROW_PIXELS,
      nameOf: (row: TreeGridRow) => row.key,
      isExpanded: (row: TreeGridRow) => (row.key === 'row 1' ? false : undefined),
    },
    slots: {
      row: ({ row, attributes }: { row: TreeGridRow; attributes: object }) =>
        h('div', attributes, [row.key, h('button', { tabindex: 0 }, 'More')]),
    },
  });
  await expect.poll(() => grid.find('[role="row"]').exists()).toBe(true);
  const focused = () => document.activeElement?.getAttribute('data-key');
  async function press(key: string, at = '[tabindex="0"][role="row"]'): Promise<void> {
    await grid.get(at).trigger('keydown', { key });
    await nextTick();
  }
  return { grid, focused, press };
}

describe('a tree grid', () => {
  it('draws the rows in view and the one that Tab reaches', async () => {
    const { grid } = await mounted(many, 'last');
    const rows = grid.findAll('[role="row"]');
    expect(rows.length).toBeLessThan(20);
    expect(grid.get('[role="row"][tabindex="0"]').attributes()).toMatchObject({
      'data-key': 'last',
      'aria-rowindex': '101',
      'aria-level': '1',
      'aria-posinset': '101',
      'aria-setsize': '101',
      'aria-selected': 'true',
    });
    expect(grid.get('[role="treegrid"]').attributes('aria-rowcount')).toBe('101');
    expect(grid.emitted('drawn')?.at(-1)).toEqual([expect.arrayContaining([many[0], many[100]])]);
  });

  it('moves the focus by keys, and to the row that begins with typed letters', async () => {
    const { focused, press } = await mounted(many);
    await press('ArrowDown');
    expect(focused()).toBe('row 1');
    await press('PageDown');
    expect(focused()).toBe('row 5');
    await press('l');
    expect(focused()).toBe('last');
  });

  it('emits what keys ask for', async () => {
    const { grid, press } = await mounted(many);
    await press('ArrowDown');
    await press('ArrowRight');
    expect(grid.emitted('expand')).toEqual([[many[1], true]]);
    await press('Enter');
    expect(grid.emitted('open')).toEqual([[many[1]]]);
    await press('*');
    expect(grid.emitted('expandSiblings')).toEqual([[many[1]]]);
    await press('F2');
    expect(grid.emitted('rowKey')).toEqual([[expect.objectContaining({ key: 'F2' }), many[1]]]);
  });

  it('leaves keys to the controls in a row', async () => {
    const { grid, press } = await mounted(many);
    await press('Enter', 'button');
    expect(grid.emitted('open')).toBeUndefined();
  });

  it('makes a clicked row the one that Tab reaches', async () => {
    const { grid } = await mounted(many);
    await grid.get('[data-key="row 3"]').trigger('click');
    expect(grid.get('[role="row"][tabindex="0"]').attributes('data-key')).toBe('row 3');
  });
});
