import { LAUNCH_WITH_CAMERA } from '../../fixtures/chromium.ts';
import { expect, test } from '../../fixtures/test.ts';
import { middleOf } from '../../pages/touch.ts';

const SHELL = 'web-interface-ubii-controller';
const GAMEPAD = 'web-interface-ubii-controller-gamepad';

test.use({ launchOptions: LAUNCH_WITH_CAMERA });

test('a phone is the controller that existing games know, and a camera when a session says so @smoke', async ({
  room,
}) => {
  const game = await room.program('game');
  const told: string[] = [];
  const sticks: { x: number; y: number }[] = [];
  const buttons = game.subscribe({ glob: `/*/${GAMEPAD}/button_*` }, { format: 'keyEvent' });
  buttons.onRecord(({ topic, value }) =>
    told.push(`${topic.split('/').at(-1)} ${value.key} ${value.type}`),
  );
  const stick = game.subscribe({ glob: `/*/${GAMEPAD}/analog_stick_left` }, { format: 'vector2' });
  stick.onRecord(({ value }) => sticks.push(value));
  const gone: string[] = [];
  const farewells = game.subscribe('removeClient', { format: 'string' });
  farewells.onRecord(({ value }) => gone.push(value));
  await Promise.all([buttons.ready, stick.ready, farewells.ready]);

  const { page } = await room.withPhone('Mara');
  await page.goto('/devices/controller');
  const find = async (name: string) =>
    (await game.call('deviceGetList', { elements: [{ name }] })).elements;
  await expect.poll(async () => (await find(GAMEPAD)).length).toBe(1);
  await expect.poll(async () => (await find(SHELL)).length).toBe(1);
  const [device] = await find(GAMEPAD);
  const id = device!.clientId;
  const prefix = `/${id}/${GAMEPAD}`;

  await test.step('its topics and formats are those of the wire protocol', () => {
    const of = (name: string, format: string, ioType: number) => ({
      topic: `${prefix}/${name}`,
      messageFormat: format,
      ioType,
    });
    expect(
      device!.components.map(({ topic, messageFormat, ioType }) => ({
        topic,
        messageFormat,
        ioType,
      })),
    ).toEqual([
      of('orientation', 'ubii.dataStructure.Vector3', 0),
      of('linear_acceleration', 'ubii.dataStructure.Vector3', 0),
      of('analog_stick_left', 'ubii.dataStructure.Vector2', 0),
      of('button_a', 'ubii.dataStructure.KeyEvent', 0),
      of('button_b', 'ubii.dataStructure.KeyEvent', 0),
      of('button_start', 'ubii.dataStructure.KeyEvent', 0),
      of('set_color', 'ubii.dataStructure.Color', 1),
      of('set_image', 'ubii.dataStructure.Image2D', 1),
      of('clear_image', 'bool', 1),
      of('vibration_pattern', 'double', 1),
    ]);
  });

  await test.step('A, B and Start are pressed and released under their keys', async () => {
    for (const name of ['A', 'B', 'Start']) {
      const { x, y } = await middleOf(page.getByRole('button', { name, exact: true }));
      await page.touchscreen.tap(x, y);
    }
    await expect
      .poll(() => told)
      .toEqual([
        'button_a 1 1',
        'button_a 1 0',
        'button_b 2 1',
        'button_b 2 0',
        'button_start start 1',
        'button_start start 0',
      ]);
  });

  await test.step('the stick is pushed upwards and springs back', async () => {
    const cdp = await page.context().newCDPSession(page);
    const box = (await page.getByRole('application', { name: /^Stick/ }).boundingBox())!;
    const at = (part: number) => ({ x: box.x + box.width / 2, y: box.y + part * box.height });
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...touchPoints: object[]) =>
      cdp.send('Input.dispatchTouchEvent', { type, touchPoints: touchPoints as never });
    await touch('touchStart', at(0.5));
    await touch('touchMove', at(0.02));
    await expect.poll(() => sticks.at(-1)?.y).toBe(1);
    expect(sticks.at(-1)?.x).toBeCloseTo(0, 1);
    await touch('touchEnd');
    await expect.poll(() => sticks.at(-1)).toEqual({ x: 0, y: 0 });
  });

  await test.step('it is held and turned', async () => {
    const turns = game.subscribe(`${prefix}/orientation`, { format: 'vector3' });
    let turn: unknown;
    turns.onRecord(({ value }) => (turn = value));
    await turns.ready;
    const cdp = await page.context().newCDPSession(page);
    await cdp.send('DeviceOrientation.setDeviceOrientationOverride', {
      alpha: 90,
      beta: 20,
      gamma: -5,
    });
    await expect.poll(() => turn).toEqual({ x: 90, y: 20, z: -5 });
  });

  await test.step('it shows colours and pictures, and takes them away', async () => {
    game.publish(`${prefix}/set_color`, 'color', { r: 0, g: 0, b: 1, a: 1 });
    await expect(page.getByTestId('screen-color')).toHaveCSS(
      'background-color',
      'color(srgb 0 0 1)',
    );
    game.publish(`${prefix}/set_image`, 'image2D', {
      width: 2,
      height: 1,
      dataFormat: 0,
      data: Uint8Array.of(0, 255),
    });
    const picture = page.getByRole('img', { name: 'The newest picture' });
    await expect(picture).toBeVisible();
    game.publish(`${prefix}/clear_image`, 'bool', true);
    await expect(picture).toHaveCount(0);
    game.publish(`${prefix}/vibration_pattern`, 'double', 3000);
    await expect(page.locator('[data-vibrating]')).toBeVisible();
  });

  await test.step('a session makes it a camera, and the game hears that the player is gone', async () => {
    game.publish(`/${id}/${SHELL}/set_controllerMode`, 'string', 'camera');
    await expect(page.getByRole('button', { name: 'Start the camera' })).toBeVisible();
    await expect.poll(() => gone).toEqual([id]);
    await expect.poll(async () => (await find('CameraWebInterface')).length).toBe(1);
    await expect.poll(async () => (await find(GAMEPAD)).length).toBe(0);
  });

  await test.step('and a gamepad again; words it does not know change nothing', async () => {
    game.publish(`/${id}/${SHELL}/set_controllerMode`, 'string', 'joycon');
    await expect(page.getByRole('button', { name: 'A', exact: true })).toBeVisible();
    game.publish(`/${id}/${SHELL}/set_controllerMode`, 'string', 'piano');
    await expect(page.getByText('asked for the mode “piano”')).toBeVisible();
    await expect(page.getByRole('button', { name: 'A', exact: true })).toBeVisible();
  });

  await test.step('leaving the page says so at once', async () => {
    await page.goto('/topics');
    await expect.poll(() => gone).toEqual([id, id]);
  });
});
