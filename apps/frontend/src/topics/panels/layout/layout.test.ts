import { describe, expect, it } from 'vitest';
import { layoutJson, linkedLayout, MAX_FILE, readLayoutFile, savedLayout } from './layout-json.ts';
import { layoutHash, layoutOfHash, MAX_LINK } from './layout-link.ts';
import { layoutRects, neighbourOf, roomiest, sideAt } from './layout-rects.ts';
import { firstStep, nextStep, redoStep, undoStep } from './layout-steps.ts';
import {
  changePanel,
  freeId,
  insertPanel,
  movePanel,
  panelsOf,
  removePanel,
  setShare,
  type Layout,
  type LayoutNode,
  type Panel,
} from './layout.ts';

const panel = (id: string, more: Partial<Panel> = {}): Panel => ({
  id,
  viewer: 'plot',
  topic: `/topic/${id}`,
  settings: {},
  ...more,
});
/** 1 on the left; 2 above 3 on the right. */
const three: LayoutNode = {
  direction: 'row',
  share: 0.4,
  first: panel('1'),
  second: { direction: 'column', share: 0.5, first: panel('2'), second: panel('3') },
};
const layout: Layout = { name: 'Ärm & Bein', root: three };
const layoutText = (members: object): string =>
  JSON.stringify({ type: 'ubi-interact-layout', version: 1, ...members });
const idsOf = (root: LayoutNode | undefined): string =>
  panelsOf(root)
    .map(({ id }) => id)
    .join('');

describe('panels', () => {
  it('stand where their splits say', () => {
    const { panels, dividers } = layoutRects(three);
    expect(panels.get('1')).toEqual({ left: 0, top: 0, width: 0.4, height: 1 });
    expect(panels.get('3')).toEqual({ left: 0.4, top: 0.5, width: 0.6, height: 0.5 });
    expect(dividers.map(({ path, direction }) => [path, direction])).toEqual([
      ['', 'row'],
      ['1', 'column'],
    ]);
  });

  it('are added where there is room, changed, and removed without a hole', () => {
    expect(roomiest(three, 1.6)).toEqual({ id: '1', side: 'bottom' });
    const four = insertPanel(three, panel(freeId(three)), { id: '1', side: 'bottom' });
    expect(idsOf(four)).toBe('1423');
    expect(idsOf(removePanel(four, '4'))).toBe('123');
    expect(removePanel(panel('1'), '1')).toBeUndefined();
    expect(panelsOf(changePanel(three, '2', { viewer: 'json' }))[1]?.viewer).toBe('json');
    expect(insertPanel(undefined, panel('1'), { id: '', side: 'right' })).toEqual(panel('1'));
  });

  it('move beside another or change places with it, and none is lost', () => {
    expect(idsOf(movePanel(three, '3', { id: '1', side: 'left' }))).toBe('312');
    expect(idsOf(movePanel(three, '1', { id: '3', side: 'middle' }))).toBe('321');
    expect(movePanel(three, '1', { id: '1', side: 'left' })).toBe(three);
    expect(movePanel(three, '9', { id: '1', side: 'left' })).toBe(three);
  });

  it('share their room within bounds', () => {
    expect(layoutRects(setShare(three, '1', 0.7)).panels.get('2')?.height).toBe(0.7);
    expect(layoutRects(setShare(three, '', 7)).panels.get('1')?.width).toBe(0.9);
  });

  it('know their neighbours', () => {
    expect(neighbourOf(three, '1', 'right')).toBe('2');
    expect(neighbourOf(three, '3', 'top')).toBe('2');
    expect(neighbourOf(three, '3', 'left')).toBe('1');
    expect(neighbourOf(three, '1', 'left')).toBeUndefined();
  });

  it('are dropped on the side that is nearest', () => {
    expect([sideAt(0.1, 0.5), sideAt(0.5, 0.9), sideAt(0.5, 0.5)]).toEqual([
      'left',
      'bottom',
      'middle',
    ]);
  });
});

describe('steps', () => {
  it('are taken back and again, a drag as one', () => {
    const [one, two] = [
      { name: '', root: panel('1') },
      { name: '', root: panel('2') },
    ];
    let steps = nextStep(firstStep(one), two, false);
    steps = nextStep(steps, { name: '', root: panel('3') }, true);
    expect(undoStep(steps).present).toBe(one);
    expect(idsOf(redoStep(undoStep(steps)).present.root)).toBe('3');
    expect(undoStep(firstStep(one)).present).toBe(one);
  });
});

describe('a layout as a file and as a link', () => {
  it('comes back as it was', () => {
    const withSettings: Layout = {
      ...layout,
      root: changePanel(three, '2', { settings: { series: [{ topic: '/ä b', path: 'x.y' }] } }),
    };
    const read = { kind: 'read', value: withSettings };
    expect(readLayoutFile(JSON.stringify(layoutJson(withSettings)))).toEqual(read);
    expect(layoutOfHash(layoutHash(withSettings)!)).toEqual(read);
    expect(layoutOfHash(layoutHash({ name: '', root: undefined })!)).toEqual({
      kind: 'read',
      value: { name: '', root: undefined },
    });
    expect(layoutOfHash('#other')).toBeUndefined();
  });

  it('is too long for a link when it is', () => {
    const long = changePanel(three, '1', { settings: { text: 'x'.repeat(MAX_LINK) } });
    expect(layoutHash({ name: '', root: long })).toBeUndefined();
  });

  it.each([
    ['{"type":"ubi-interact-lay', 'not JSON'],
    ['[]', 'contains no layout of panels'],
    ['{"type":"else"}', 'contains no layout of panels'],
    [layoutText({ version: 9 }), 'version 9'],
    [layoutText({ root: 7 }), 'root should be an object.'],
    [layoutText({ root: { split: 'x' } }), 'root.split should be "row" or "column".'],
    [layoutText({ root: { panel: '1' } }), 'root.topic is missing.'],
    [
      layoutText({ root: { panel: '<b>', topic: '/a' } }),
      'root.panel should have 1 to 40 letters and digits.',
    ],
    [
      layoutText({ root: { panel: '1', topic: '/a', settings: { text: 'x'.repeat(8000) } } }),
      'root.settings is too large.',
    ],
    [
      layoutText({ root: { panel: '1', topic: '/a', settings: { a: '?' } } }).replace(
        '"?"',
        '{"a":'.repeat(9000) + '0' + '}'.repeat(9000),
      ),
      'nested too deeply',
    ],
    ['x'.repeat(MAX_FILE + 1), 'too large'],
  ])('damaged, says what is wrong: %.60s', (text, reason) => {
    expect(readLayoutFile(text)).toEqual({
      kind: 'broken',
      message: expect.stringContaining(reason) as string,
    });
  });

  it('in a link that was cut off, says so', () => {
    const hash = layoutHash(layout)!;
    const cutOff = { kind: 'broken', message: expect.stringContaining('cut off') as string };
    expect(layoutOfHash(hash.slice(0, -9))).toEqual(cutOff);
    expect(layoutOfHash('#layout=%%%')).toEqual(cutOff);
  });

  it('never holds more panels than a page shows, nor one twice', () => {
    let many: LayoutNode = panel('0');
    for (let i = 1; i < 13; i++) {
      many = { direction: 'row', share: 0.5, first: panel(String(i)), second: many };
    }
    expect(linkedLayout(layoutJson({ name: '', root: many }))).toEqual({
      kind: 'broken',
      message: 'The link cannot be read: the layout has 13 panels; a page shows up to 12.',
    });
    const twice: LayoutNode = {
      direction: 'row',
      share: 0.5,
      first: panel('1'),
      second: panel('1'),
    };
    expect(linkedLayout(layoutJson({ name: '', root: twice }))).toEqual({
      kind: 'broken',
      message: 'The link cannot be read: two panels have the same id.',
    });
  });
});

describe('a layout saved with a session', () => {
  it('is read as that of a file, and says where it was damaged', () => {
    expect(savedLayout(layoutJson(layout))).toEqual({ kind: 'read', value: layout });
    expect(savedLayout({ ...layoutJson(layout), root: { panel: '1' } })).toEqual({
      kind: 'broken',
      message: 'The session cannot be read: root.topic is missing.',
    });
    expect(savedLayout('panels')).toMatchObject({ kind: 'broken' });
  });
});
