import type { CDPSession, Page } from '@playwright/test';
import { TouchEventType } from '@ubii/proto';
import { LAUNCH_WITH_SENSORS } from '../../fixtures/chromium.ts';
import { expect, test, type Person } from '../../fixtures/test.ts';
import { middleOf } from '../../pages/touch.ts';

test.use({ launchOptions: LAUNCH_WITH_SENSORS });

const DEVICE = 'web-interface-smart-device';

/** The id of the page's client, as its device's topics tell it. */
async function openSmartDevice(person: Person, name: string): Promise<void> {
  await person.page.goto('/devices/smart-device');
  await expect(person.page.getByRole('button', { name: 'Change your name' })).toContainText(name);
}

async function sensors(page: Page): Promise<CDPSession> {
  return page.context().newCDPSession(page);
}

test('a phone is a device with the names that existing programs look for, touched with two fingers @smoke', async ({
  room,
}) => {
  const program = await room.program('listener');
  const phone = await room.withPhone('Mara');
  const touches = program.subscribe({ glob: '/*/touch_events' }, { format: 'touchEventList' });
  const seen: { type: number; id: string; x: number; y: number }[] = [];
  touches.onRecord(({ value }) => {
    for (const { type, id, position } of value.elements) {
      seen.push({ type, id, x: position?.x ?? NaN, y: position?.y ?? NaN });
    }
  });
  await openSmartDevice(phone, 'Mara');

  await test.step('its components have the names, topics and tags of the wire protocol', async () => {
    await expect
      .poll(async () => (await program.call('deviceGetList', {})).elements.map(({ name }) => name))
      .toContain(DEVICE);
    const { elements } = await program.call('deviceGetList', { elements: [{ name: DEVICE }] });
    const device = elements[0]!;
    expect(device.tags).toEqual(['smart device', 'web interface']);
    const id = device.clientId;
    expect(device.components.slice(0, 4)).toMatchObject([
      {
        name: 'web-component-linear-acceleration',
        topic: `/${id}/${DEVICE}/linear_acceleration`,
        messageFormat: 'ubii.dataStructure.Vector3',
        tags: ['acceleration', 'linear'],
      },
      {
        name: 'web-component-orientation',
        topic: `${id}/orientation`,
        messageFormat: 'ubii.dataStructure.Vector3',
        tags: ['imu', 'orientation'],
      },
      {
        name: 'web-component-touch',
        topic: `/${id}/touch_events`,
        messageFormat: 'ubii.dataStructure.TouchEventList',
        tags: ['touch'],
      },
      {
        name: 'web-component-vibration',
        topic: `/${id}/vibration_pattern`,
        messageFormat: 'double',
        tags: ['vibration'],
      },
    ]);
  });

  await test.step('two fingers start, move and end under their own numbers', async () => {
    const cdp = await sensors(phone.page);
    const box = (await phone.page.getByRole('application', { name: 'Touch pad' }).boundingBox())!;
    const at = (x: number, y: number, id: number) => ({
      x: box.x + x * box.width,
      y: box.y + y * box.height,
      id,
    });
    const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...touchPoints: object[]) =>
      cdp.send('Input.dispatchTouchEvent', { type, touchPoints: touchPoints as never });
    await send('touchStart', at(0.2, 0.3, 0));
    await send('touchStart', at(0.2, 0.3, 0), at(0.7, 0.6, 1));
    await send('touchMove', at(0.4, 0.5, 0), at(0.7, 0.9, 1));
    await expect
      .poll(
        () =>
          new Set(
            seen.filter(({ type }) => type === TouchEventType.TOUCH_MOVE).map(({ id }) => id),
          ),
      )
      .toEqual(new Set(['1', '2']));
    await send('touchEnd');
    await expect
      .poll(() => seen.filter(({ type }) => type === TouchEventType.TOUCH_END))
      .toHaveLength(2);
    const first = seen.find(({ type, id }) => type === TouchEventType.TOUCH_START && id === '1')!;
    expect(first.x).toBeCloseTo(0.2, 1);
    expect(first.y).toBeCloseTo(0.3, 1);
    const last = seen.findLast(({ id }) => id === '2')!;
    expect(last.y).toBeCloseTo(0.9, 1);
  });

  await test.step('a button is pressed and released', async () => {
    const keys = program.subscribe({ glob: `/*/${DEVICE}/button` }, { format: 'keyEvent' });
    const pressed: string[] = [];
    keys.onRecord(({ value }) => pressed.push(`${value.key} ${value.type}`));
    await keys.ready;
    const { x, y } = await middleOf(phone.page.getByRole('button', { name: 'Button 2' }));
    await phone.page.touchscreen.tap(x, y);
    await expect.poll(() => pressed).toEqual(['2 1', '2 0']);
  });

  await test.step('text is sent as typed', async () => {
    const texts = program.subscribe({ glob: `/*/${DEVICE}/text` }, { format: 'string' });
    const read: string[] = [];
    texts.onRecord(({ value }) => read.push(value));
    await texts.ready;
    await phone.page.getByRole('button', { name: 'Send text' }).tap();
    await phone.page.getByRole('textbox', { name: 'Text to send' }).fill('Grüße, 123');
    await phone.page.getByRole('button', { name: 'Send', exact: true }).tap();
    await expect.poll(() => read).toEqual(['Grüße, 123']);
  });
});

test('motion and orientation are sent at the rate the sensors have, and calibrated', async ({
  room,
}) => {
  const program = await room.program('listener');
  const phone = await room.withPhone('Mara');
  await openSmartDevice(phone, 'Mara');
  const { page } = phone;

  const angles = program.subscribe({ glob: '*/orientation' }, { format: 'vector3' });
  const turns = program.subscribe(
    { glob: `/*/${DEVICE}/orientation_quaternion` },
    { format: 'quaternion' },
  );
  let angle: { x: number; y: number; z: number } | undefined;
  let turn: { w: number } | undefined;
  angles.onRecord(({ value }) => (angle = value));
  turns.onRecord(({ value }) => (turn = value));
  await Promise.all([angles.ready, turns.ready]);

  const cdp = await sensors(page);
  const turnTo = (alpha: number, beta: number, gamma: number) =>
    cdp.send('DeviceOrientation.setDeviceOrientationOverride', { alpha, beta, gamma });
  // Again and again, as sensors do: one reading can be over before the page listens, and one that repeats the last is none.
  const turned = async () => {
    const before = angle;
    await turnTo(0, 0, 0);
    await turnTo(90, 20, -5);
    return before;
  };
  await expect.poll(turned).toEqual({ x: 90, y: 20, z: -5 });
  await expect(page.getByText('yaw 90', { exact: false })).toBeVisible();

  await page.getByRole('button', { name: /^Calibrate/ }).tap();
  await turnTo(90, 30, -5);
  await expect.poll(() => angle).toEqual({ x: 0, y: 10, z: 0 });
  // Ten degrees are half of it in the cosine.
  await expect.poll(() => turn?.w).toBeCloseTo(Math.cos((5 * Math.PI) / 180), 3);

  const motions = program.subscribe({ glob: `/*/${DEVICE}/acceleration` }, { format: 'vector3' });
  let motion: { x: number; y: number; z: number } | undefined;
  motions.onRecord(({ value }) => (motion = value));
  await motions.ready;
  await cdp.send('Emulation.setSensorOverrideEnabled', { enabled: true, type: 'accelerometer' });
  await cdp.send('Emulation.setSensorOverrideEnabled', {
    enabled: true,
    type: 'linear-acceleration',
  });
  await cdp.send('Emulation.setSensorOverrideEnabled', { enabled: true, type: 'gyroscope' });
  await page.reload();
  for (const type of ['accelerometer', 'linear-acceleration', 'gyroscope'] as const) {
    await cdp.send('Emulation.setSensorOverrideReadings', {
      type,
      reading: { xyz: { x: 0.5, y: -0.25, z: 9.8 } },
    });
  }
  await expect.poll(() => motion?.z).toBeCloseTo(9.8, 1);
});

test('a phone does what it is sent: words, colour, a picture, a tone, and a flash where it cannot vibrate', async ({
  room,
}) => {
  const program = await room.program('stage');
  const phone = await room.withPhone('Mara');
  await keepLocks(phone.page);
  await openSmartDevice(phone, 'Mara');
  const { page } = phone;
  await expect
    .poll(
      async () => (await program.call('deviceGetList', { elements: [{ name: DEVICE }] })).elements,
    )
    .toHaveLength(1);
  const { elements } = await program.call('deviceGetList', { elements: [{ name: DEVICE }] });
  const id = elements[0]!.clientId;

  program.publish(`/${id}/${DEVICE}/show_text`, 'string', 'Turn left');
  await expect(page.getByRole('status').filter({ hasText: 'Turn left' })).toBeVisible();
  program.publish(`/${id}/${DEVICE}/set_color`, 'color', { r: 1, g: 0, b: 0, a: 1 });
  await expect(page.getByTestId('pad-color')).toHaveCSS('background-color', 'color(srgb 1 0 0)');
  program.publish(`/${id}/${DEVICE}/set_color`, 'color', { r: 0, g: 0, b: 0, a: 0 });
  await expect(page.getByTestId('pad-color')).toHaveCount(0);
  program.publish(`/${id}/${DEVICE}/show_image`, 'image2D', {
    width: 2,
    height: 1,
    dataFormat: 0,
    data: Uint8Array.of(0, 255),
  });
  await expect(page.getByRole('img', { name: 'The newest picture' })).toBeVisible();

  const row = (title: string) =>
    page.getByRole('listitem').filter({ hasText: new RegExp(`^\\s*${title}`) });
  await test.step('it is silent until it is touched, and says so', async () => {
    const tone = { x: 440, y: 40, z: 0.1 };
    program.publish(`/${id}/${DEVICE}/play_tone`, 'vector3', tone);
    await expect(row('Sound')).toContainText('Tap once to hear the next');
    await page.getByRole('application', { name: 'Touch pad' }).tap();
    await expect(async () => {
      program.publish(`/${id}/${DEVICE}/play_tone`, 'vector3', tone);
      await expect(row('Sound')).toContainText(/Listening, last/, { timeout: 1000 });
    }).toPass();
  });

  await page.evaluate(() => Object.defineProperty(navigator, 'vibrate', { value: () => false }));
  program.publish(`/${id}/vibration_pattern`, 'double', 3000);
  await expect(page.locator('[data-flashing]')).toBeVisible();
  await expect(row('Vibrate')).toContainText(/Listening, last/);

  await test.step('it stays awake, and again after it was hidden, which ends that', async () => {
    await expect(row('Screen stays on')).toContainText('on');
    await show(page, 'hidden');
    await expect(row('Screen stays on')).toContainText('off');
    await show(page, 'visible');
    await expect(row('Screen stays on')).toContainText('on');
  });
});

/** Keeps at hand what holds the screen on: a browser of a test is never really hidden. */
async function keepLocks(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const locks: WakeLockSentinel[] = [];
    const { wakeLock } = navigator;
    const request = wakeLock.request.bind(wakeLock);
    wakeLock.request = async (type) => {
      const lock = await request(type);
      locks.push(lock);
      return lock;
    };
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') for (const lock of locks) void lock.release();
    });
  });
}

async function show(page: Page, state: DocumentVisibilityState): Promise<void> {
  await page.evaluate((now) => {
    Object.defineProperty(document, 'visibilityState', { value: now, configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  }, state);
}
