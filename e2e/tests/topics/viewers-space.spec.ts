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

test('a rotation is drawn in space, and looked at from all sides', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/turn', 'quaternion', { x: 0, y: 0, z: 0, w: 1 });
  const view = new SpaceView(await room.atDesk());
  await view.open('/lab/turn');
  await expect(view.word('x')).toBeVisible();

  await test.step('a rotation is drawn as it is: its axes point where they are turned to', async () => {
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

    robot.publish('/lab/turn', 'quaternion', { x: 0, y: 0, z: 0, w: 1 });
    await expect.poll(async () => distance(await view.placeOf('x'), x)).toBeLessThan(2);
  });

  await test.step('the view is turned, moved and zoomed by keys, mouse and wheel, and comes back', async () => {
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

  await test.step('a picture that the graphics card takes away is drawn again', async () => {
    robot.publish('/lab/turn', 'quaternion', { x: 0, y: 0, z: HALF, w: HALF });
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

  await test.step('without WebGL the numbers are there, and why', async () => {
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
});

/** Neighbours differ in colour: what is left of the one before is none of the next. */
const SHOWN: { readonly [F in DataFormat]?: readonly [DataFormatValues[F], string, RegExp] } = {
  quaternion: [{ x: HALF, y: 0, z: 0, w: HALF }, '--family-rotation', /roll 90°/],
  vector3: [{ x: 1, y: 2, z: 0.5 }, '--family-vector', /at 1\.00, 2\.00, 0\.50/],
  quaternionList: [{ x: 0, y: HALF, z: 0, w: HALF }, '--family-rotation', /pitch 90°/],
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
  matrix3x2: [{ m00: 0, m01: 1, m10: -1, m11: 0, m20: 1, m21: 0 }, '--family-rotation', /yaw 90°/],
  object3D: [
    { id: 'cup', pose: pose(0, 1, 0), size: { x: 1, y: 1, z: 1 }, userDataJson: '' },
    '--family-objects',
    /cup at 0\.00, 1\.00, 0\.00/,
  ],
  matrix4x4: [
    { ...matrix, m00: 0, m01: -1, m10: 1, m11: 0, m03: 1 },
    '--family-rotation',
    /at 1\.00, 0\.00, 0\.00 yaw 90°/,
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
  pose3D: [pose(1, 0.5, 0), '--family-rotation', /at 1\.00, 0\.50, 0\.00/],
};

test('values in space are drawn, told in words and named', async ({ room }) => {
  test.slow();
  const robot = await room.program('Robot');
  const view = new SpaceView(await room.atDesk());
  const select = async (format: string): Promise<void> => {
    await view.page.getByRole('rowheader', { name: new RegExp(`\\b${format}$`) }).click();
    await view.page.getByRole('radio', { name: '3D' }).click();
  };
  for (const [format, [value]] of Object.entries(SHOWN)) {
    robot.publish(`/space/${format}`, format as DataFormat, value as never);
  }
  await view.open('/space/pose3D');

  await test.step('every data format that has a place in space is drawn and told in words', async () => {
    for (const [format, [, token, words]] of Object.entries(SHOWN)) {
      await test.step(format, async () => {
        await select(format);
        await expect(view.canvas).toHaveAccessibleName(words);
        await expect.poll(async () => view.pixelsOf(token)).toBeGreaterThan(15);
      });
    }
  });

  await test.step('things have their names, and their numbers beside the picture', async () => {
    await select('object3DList');
    await expect(view.word('cup')).toBeVisible();
    await expect(view.word('lamp')).toBeVisible();
    const [cup, lamp] = [await view.placeOf('cup'), await view.placeOf('lamp')];
    expect(lamp.right).toBeGreaterThan(cup.right);
    await view.page.getByRole('button', { name: 'Show numbers' }).click();
    const table = view.page.getByRole('group', { name: 'Numbers' });
    await expect(table.getByRole('row')).toHaveCount(3);
    await expect(table.getByRole('row').last()).toContainText('lamp');
  });
});
