import { DATA_FORMATS, type DataFormat, type DataFormatValues } from '@ubii/proto';
import { expect, test } from '../../fixtures/test.ts';
import { SpaceView, type Place } from '../../pages/space-view.ts';

const HALF = Math.SQRT1_2;
const distance = (a: Place, b: Place): number => Math.hypot(a.right - b.right, a.up - b.up);
const pose = (x: number, y: number, z: number) => ({
  position: { x, y, z },
  quaternion: { x: 0, y: 0, z: 0, w: 1 },
});
const matrix = DATA_FORMATS.matrix4x4.createDefault();

test('a rotation is drawn as it is: its axes point where they are turned to', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/turn', 'quaternion', { x: 0, y: 0, z: 0, w: 1 });
  const view = new SpaceView(await room.atDesk());
  await view.open('/lab/turn');
  await expect(view.word('x')).toBeVisible();
  const x = await view.placeOf('x');
  const y = await view.placeOf('y');
  const z = await view.placeOf('z');
  expect(y.up).toBeGreaterThan(50);
  expect(Math.abs(y.right)).toBeLessThan(4);
  expect(x.right).toBeGreaterThan(50);
  expect(z.right).toBeLessThan(-20);
  // Each arm has a colour of its own, and is really there.
  for (const token of ['--family-rotation', '--space-arm-y', '--space-arm-z']) {
    expect(await view.pixelsOf(token), token).toBeGreaterThan(40);
  }

  // A quarter about z takes x to where y was, and y to the other side of where x was.
  robot.publish('/lab/turn', 'quaternion', { x: 0, y: 0, z: HALF, w: HALF });
  await expect(view.canvas).toHaveAccessibleName(/yaw 90°/);
  await expect.poll(async () => distance(await view.placeOf('x'), y)).toBeLessThan(6);
  expect(distance(await view.placeOf('z'), z)).toBeLessThan(6);
  expect((await view.placeOf('y')).right).toBeLessThan(-50);

  // A quarter about y takes z to where x was.
  robot.publish('/lab/turn', 'quaternion', { x: 0, y: HALF, z: 0, w: HALF });
  await expect.poll(async () => distance(await view.placeOf('z'), x)).toBeLessThan(6);
});

test('the view is turned, moved and zoomed by keys, mouse and wheel, and comes back', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/turn', 'quaternion', { x: 0, y: 0, z: 0, w: 1 });
  const view = new SpaceView(await room.atDesk());
  await view.open('/lab/turn');
  await expect(view.word('x')).toBeVisible();
  const start = await view.placeOf('x');
  const moved = async () => distance(await view.placeOf('x'), start);
  await view.frame.focus();
  await view.page.keyboard.press('ArrowLeft');
  await expect.poll(moved).toBeGreaterThan(4);
  await view.page.keyboard.press('0');
  await expect.poll(moved).toBeLessThan(2);
  await view.page.keyboard.press('+');
  await expect.poll(async () => (await view.placeOf('x')).right).toBeGreaterThan(start.right + 5);
  await view.page.keyboard.press('0');
  await view.page.keyboard.press('Shift+ArrowRight');
  await expect.poll(async () => (await view.placeOf('x')).right).toBeLessThan(start.right - 5);
  await view.page.getByRole('button', { name: /^Reset view/ }).click();
  await expect.poll(moved).toBeLessThan(2);
  const box = (await view.frame.boundingBox())!;
  await view.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await view.page.mouse.down();
  await view.page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2);
  await view.page.mouse.up();
  await expect.poll(moved).toBeGreaterThan(10);
  await view.page.keyboard.press('0');
  await view.page.mouse.wheel(0, 200);
  await expect.poll(async () => (await view.placeOf('x')).right).toBeLessThan(start.right - 5);
  await view.page.keyboard.press('0');
  // The other convention: z up.
  await view.page.getByRole('radio', { name: 'z up' }).click();
  await expect.poll(async () => (await view.placeOf('z')).up).toBeGreaterThan(50);
});

const SHOWN: { readonly [F in DataFormat]?: readonly [DataFormatValues[F], string, RegExp] } = {
  vector3: [{ x: 1, y: 2, z: 0.5 }, '--family-vector', /at 1\.00, 2\.00, 0\.50/],
  vector3List: [
    {
      elements: [
        { x: 1, y: 1, z: 1 },
        { x: -1, y: 0.5, z: 0 },
      ],
    },
    '--family-vector',
    /2 things/,
  ],
  quaternion: [{ x: HALF, y: 0, z: 0, w: HALF }, '--family-rotation', /roll 90°/],
  quaternionList: [{ x: 0, y: HALF, z: 0, w: HALF }, '--family-rotation', /pitch 90°/],
  matrix3x2: [{ m00: 0, m01: 1, m10: -1, m11: 0, m20: 1, m21: 0 }, '--family-rotation', /yaw 90°/],
  matrix4x4: [
    { ...matrix, m00: 0, m01: -1, m10: 1, m11: 0, m03: 1 },
    '--family-rotation',
    /at 1\.00, 0\.00, 0\.00 yaw 90°/,
  ],
  pose3D: [pose(1, 0.5, 0), '--family-rotation', /at 1\.00, 0\.50, 0\.00/],
  object3D: [
    { id: 'cup', pose: pose(0, 1, 0), size: { x: 1, y: 1, z: 1 }, userDataJson: '' },
    '--family-objects',
    /cup at 0\.00, 1\.00, 0\.00/,
  ],
  object3DList: [
    {
      elements: ['cup', 'lamp'].map((id, index) => ({
        id,
        pose: pose(index, 0.5, 0),
        size: { x: 0.5, y: 0.5, z: 0.5 },
        userDataJson: '',
      })),
    },
    '--family-objects',
    /2 things/,
  ],
};

test('every data format that has a place in space is drawn and told in words', async ({ room }) => {
  test.slow();
  const robot = await room.program('Robot');
  const view = new SpaceView(await room.atDesk());
  for (const [format, [value, token, words]] of Object.entries(SHOWN)) {
    await test.step(format, async () => {
      robot.publish(`/space/${format}`, format as DataFormat, value as never);
      await view.open(`/space/${format}`);
      await view.page.getByRole('radio', { name: '3D' }).click();
      await expect(view.canvas).toHaveAccessibleName(words);
      await expect.poll(async () => view.pixelsOf(token)).toBeGreaterThan(15);
    });
  }
});

test('things have their names, and their numbers beside the picture', async ({ room }) => {
  const robot = await room.program('Robot');
  const [value] = SHOWN.object3DList!;
  robot.publish('/lab/things', 'object3DList', value);
  const view = new SpaceView(await room.atDesk());
  await view.open('/lab/things');
  await expect(view.word('cup')).toBeVisible();
  await expect(view.word('lamp')).toBeVisible();
  const [cup, lamp] = [await view.placeOf('cup'), await view.placeOf('lamp')];
  expect(lamp.right).toBeGreaterThan(cup.right);
  await view.page.getByRole('button', { name: 'Show numbers' }).click();
  const table = view.page.getByRole('group', { name: 'Numbers' });
  await expect(table.getByRole('row')).toHaveCount(3);
  await expect(table.getByRole('row').last()).toContainText('lamp');
});

test('without WebGL the numbers are there, and why', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/turn', 'quaternion', { x: 0, y: 0, z: HALF, w: HALF });
  const { page } = await room.atDesk();
  await page.addInitScript(() => {
    const open = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...all: never[]) {
      const [kind] = all as string[];
      return kind === 'webgl2' ? null : Reflect.apply(open, this, all);
    } as typeof open;
  });
  await page.goto('/topics/%2Flab%2Fturn');
  await expect(page.getByText('This browser does not support WebGL')).toBeVisible();
  await expect(page.getByRole('group', { name: 'Numbers' })).toContainText('90.0°');
});

test('a picture that the graphics card takes away is drawn again', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/turn', 'quaternion', { x: 0, y: 0, z: HALF, w: HALF });
  const view = new SpaceView(await room.atDesk());
  await view.open('/lab/turn');
  await expect(view.word('x')).toBeVisible();
  await view.frame.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
    canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!.loseContext();
  });
  await expect(
    view.page.getByText('The browser lost the connection to the graphics card'),
  ).toBeVisible();
  await expect(view.page.getByRole('group', { name: 'Numbers' })).toContainText('90.0°');
  await view.page.getByRole('button', { name: 'Try again' }).click();
  await expect(view.word('x')).toBeVisible();
  expect(await view.pixelsOf('--family-rotation')).toBeGreaterThan(40);
});
