import type { Page } from '@playwright/test';
import {
  ButtonEventType,
  DATA_FORMATS,
  SERVICES,
  TouchEventType,
  type DataFormat,
} from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { HostileClient } from '../../fixtures/hostile-client.ts';
import {
  expectAccessible,
  expectAccessibleEverywhere,
  onPhone,
} from '../../fixtures/accessible.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { Shell } from '../../pages/shell.ts';
import { TopicsPage } from '../../pages/topics-page.ts';

const path = (topic: string): string => `/topics/${encodeURIComponent(topic)}`;
const box = (id: string, x: number, y: number, width: number, height: number) => ({
  id,
  pose: { position: { x, y } },
  size: { x: width, y: height },
  userDataJson: '',
});
const PICTURE = {
  width: 40,
  height: 20,
  dataFormat: 1,
  data: new Uint8Array(2400).fill(90),
} as const;

test('a picture is drawn with its boxes, or says what is wrong with it', async ({
  master,
  room,
}) => {
  const robot = await room.program('Robot');
  const { page } = await room.atDesk();

  await test.step('boxes of another topic are drawn over a picture, where they are', async () => {
    robot.publish('/cam/image', 'image2D', PICTURE);
    robot.publish('/cam/objects', 'object2DList', { elements: [box('cup', 0.5, 0.25, 0.25, 0.5)] });
    robot.publish('/other/pose', 'pose2D', { position: { x: 0, y: 0 } });
    await page.goto(path('/cam/image'));
    await expect(page.getByText('40 × 20 RGB8 2.4 kB')).toBeVisible();
    await page.getByRole('button', { name: 'Add overlay' }).click();
    const choices = page.getByRole('checkbox');
    await expect(choices).toHaveCount(2);
    await choices.first().check();
    await page.keyboard.press('Escape');
    const cup = page.locator('[data-over="/cam/objects"] [data-shape="cup"] path').last();
    await expect(cup).toBeVisible();
    // The picture is twice as wide as high, and fills one of the two.
    const frame = (await page.getByRole('img', { name: 'The newest picture' }).boundingBox())!;
    const unit = Math.min(frame.width / 40, frame.height / 20);
    const left = frame.x + (frame.width - 40 * unit) / 2;
    const top = frame.y + (frame.height - 20 * unit) / 2;
    const drawn = (await cup.boundingBox())!;
    // Its middle: browsers add the width of strokes to the size of a path.
    expect(Math.abs(drawn.x + drawn.width / 2 - (left + 25 * unit))).toBeLessThan(2);
    expect(Math.abs(drawn.y + drawn.height / 2 - (top + 10 * unit))).toBeLessThan(2);
    expect(Math.abs(drawn.width - 10 * unit)).toBeLessThan(12);

    robot.publish('/cam/objects', 'object2DList', { elements: [box('cup', 0, 0, 0.25, 0.5)] });
    await expect.poll(async () => (await cup.boundingBox())!.x).toBeLessThan(left + 6);
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Save the picture as PNG' }).click();
    expect((await download).suggestedFilename()).toBe('cam-image.png');
  });

  await test.step('a picture that is none says what it claims and what it has', async () => {
    const guest = await HostileClient.register(master.endpoints, 'guest');
    const socket = await guest.open();
    await socket.publish([
      {
        topic: '/guest/image',
        image2D: { width: 64, height: 48, dataFormat: 1, data: new Uint8Array(64 * 48) },
      },
    ]);
    await page.goto(path('/guest/image'));
    await expect(page.getByRole('alert')).toContainText('64 × 48 RGB8 needs 9 216 bytes');
    await expect(page.getByRole('alert')).toContainText('The data matches the format GRAY8.');
    guest.leave();
  });
});

test('values are shown as bytes, events and tables', async ({ master, room }) => {
  const robot = await room.program('Robot');
  const desk = await room.atDesk();
  const { page } = desk;

  await test.step('a record is looked at byte by byte, and what is selected is read as numbers', async () => {
    robot.publish('/lab/word', 'string', 'ABCDEFGH and more');
    await page.goto(path('/lab/word'));
    await page.getByRole('radio', { name: 'Bytes' }).click();
    await page.getByRole('radio', { name: 'Text' }).click();
    const bytes = page.getByRole('group', { name: 'Bytes', exact: true });
    await expect(bytes).toContainText('4142434445464748');
    await bytes.focus();
    await page.keyboard.press('ArrowRight');
    for (let count = 0; count < 3; count++) await page.keyboard.press('Shift+ArrowRight');
    const status = page.getByRole('status', { name: 'Selection of Bytes' });
    await expect(status).toHaveText('4 bytes at 0 (0x0)');
    await expect(page.getByText('int32 1145258561')).toBeVisible();
    await bytes.locator('[data-at="2"]').first().click();
    await expect(status).toHaveText('1 byte at 2 (0x2)');
  });

  await test.step('keys are counted, shown while they are down, and listed', async () => {
    const { DOWN, UP } = ButtonEventType;
    const press = (key: string, type: ButtonEventType): void =>
      robot.publish('/desk/key', 'keyEvent', { key, type });
    press('a', DOWN);
    await page.goto(path('/desk/key'));
    const lanes = page.getByRole('table').filter({ hasText: 'Last 10 s' });
    await expect(lanes.getByRole('row', { name: /a is down/ })).toBeVisible();
    press('a', UP);
    press('b', DOWN);
    press('b', UP);
    press('b', DOWN);
    await expect(lanes.getByRole('row', { name: /a is up/ })).toContainText('11');
    await expect(lanes.getByRole('row', { name: /b is down/ })).toContainText('21');
    const list = page.getByRole('list', { name: 'Last events' });
    await expect(list.getByRole('listitem').first()).toContainText('b down');
    await expect(list.getByRole('listitem')).toHaveCount(5);
  });

  await test.step('fingers are on a pad where they touch, hollow once they left', async () => {
    const { TOUCH_START, TOUCH_MOVE, TOUCH_END } = TouchEventType;
    const touch = (id: string, type: TouchEventType, x: number, y: number) => ({
      id,
      type,
      position: { x, y },
      force: 0,
    });
    robot.publish('/pad/touches', 'touchEventList', {
      elements: [touch('1', TOUCH_START, 0.25, 0.25), touch('2', TOUCH_START, 0.75, 0.5)],
    });
    await page.goto(path('/pad/touches'));
    const pad = page.getByRole('img', { name: '2 fingers down' });
    await expect(pad).toBeVisible();
    const surface = (await pad.boundingBox())!;
    const placeOf = async (id: string) => {
      const dot = (await page.locator(`[data-shape="${id}"] circle`).boundingBox())!;
      return [
        (dot.x + dot.width / 2 - surface.x) / surface.width,
        (dot.y + dot.height / 2 - surface.y) / surface.height,
      ];
    };
    const [x, y] = await placeOf('2');
    expect(x).toBeCloseTo(0.75, 1);
    expect(y).toBeCloseTo(0.5, 1);
    robot.publish('/pad/touches', 'touchEventList', {
      elements: [touch('1', TOUCH_MOVE, 0.5, 0.9), touch('2', TOUCH_END, 0.75, 0.5)],
    });
    await expect(page.getByRole('img', { name: '1 finger down' })).toBeVisible();
    await expect.poll(async () => (await placeOf('1'))[1]).toBeGreaterThan(0.85);
  });

  await test.step('in a narrow panel, the parts of the events stand one below the other', async () => {
    const reply = await callService(master.endpoints, {
      topic: SERVICES.sessionRuntimeAdd.topic,
      session: {
        name: 'Touches',
        processingModules: [{ id: 'gate', name: 'threshold' }],
        ioMappings: [
          {
            processingModuleId: 'gate',
            inputMappings: [{ inputName: 'value', topic: '/pad/touch' }],
          },
        ],
      },
    });
    const graph = new GraphPage(desk);
    await graph.open(reply.session!.id);
    await graph.node('Topic /pad/touch').click();
    for (let i = 0; i < 12; i++) {
      for (const type of [TouchEventType.TOUCH_START, TouchEventType.TOUCH_END]) {
        const position = { x: i / 12, y: 0.5 };
        robot.publish('/pad/touch', 'touchEvent', { id: `finger-${i}`, type, position, force: 1 });
      }
    }
    const events = graph.inspector.getByRole('group', { name: 'Events' });
    const list = events.getByRole('list', { name: 'Last events' });
    await expect(list.getByRole('listitem')).not.toHaveCount(0);
    const boxes = await Promise.all(
      [events.getByRole('table'), list, events.getByRole('img')].map((part) => part.boundingBox()),
    );
    const edges = boxes
      .map((box) => ({ top: box!.y, bottom: box!.y + box!.height }))
      .sort((a, b) => a.top - b.top);
    expect(edges[1]!.top).toBeGreaterThanOrEqual(edges[0]!.bottom);
    expect(edges[2]!.top).toBeGreaterThanOrEqual(edges[1]!.bottom);
  });

  await test.step('lists and matrices are tables', async () => {
    robot.publish('/lab/numbers', 'doubleList', { elements: [0.5, -2, 7] });
    robot.publish('/lab/matrix', 'matrix4x4', {
      ...DATA_FORMATS.matrix4x4.createDefault(),
      m03: 2.5,
    });
    await page.goto(path('/lab/numbers'));
    await page.getByRole('radio', { name: 'Table' }).click();
    const table = page.getByRole('group', { name: 'Table' });
    await expect(table.getByRole('row')).toHaveCount(4);
    await expect(table.getByRole('row').nth(2)).toContainText('−2.000');
    await page.goto(path('/lab/matrix'));
    await page.getByRole('radio', { name: 'Table' }).click();
    await expect(table.getByRole('row').nth(1)).toContainText('2.500');
  });
});

const LOOKS: readonly (readonly [DataFormat, unknown, readonly string[]])[] = [
  ['pose3D', DATA_FORMATS.pose3D.createDefault(), ['3D', 'Bytes']],
  ['object2DList', { elements: [box('cup', 0.1, 0.1, 0.3, 0.3)] }, ['2D', 'Table']],
  [
    'touchEventList',
    { elements: [{ id: '1', type: 0, position: { x: 0.5, y: 0.5 } }] },
    ['Events'],
  ],
  ['image2D', PICTURE, ['Picture']],
];

test('the views of values are accessible and fit a phone', async ({ room }) => {
  const robot = await room.program('Robot');
  const { page } = await room.atDesk('Anna', { colorScheme: 'dark' });
  for (const [format, value] of LOOKS) robot.publish(`/look/${format}`, format, value as never);
  const { detail } = new TopicsPage({ page });
  for (const [format, , views] of LOOKS) {
    await page.goto(path(`/look/${format}`));
    for (const view of views) {
      await test.step(`${format} ${view}`, async () => {
        await detail.getByRole('radio', { name: view, exact: true }).click();
        if (view === '3D') await expect(detail.locator('.labels i').first()).toBeVisible();
        await expectAccessibleEverywhere(page);
        await expectToFit(page);
        await onPhone(page, () => expectToFit(page));
      });
    }
  }
  await test.step('colours of what only phones show', () =>
    onPhone(page, () => expectAccessible(page)));
});

async function expectToFit(page: Page): Promise<void> {
  expect(await new Shell(page).overflowPx()).toBe(0);
}
