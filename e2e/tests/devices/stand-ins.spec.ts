import type { Page } from '@playwright/test';
import { expect, test } from '../../fixtures/test.ts';

/** A pad that the test holds; there is no other way to have one without hardware. */
async function plugIn(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const pad = {
      id: 'Test pad',
      index: 0,
      connected: true,
      mapping: 'standard',
      timestamp: 0,
      axes: [0, 0, 0, 0],
      buttons: Array.from({ length: 17 }, () => ({ pressed: false, touched: false, value: 0 })),
      rumbles: [] as number[],
      vibrationActuator: {
        playEffect: async (_kind: string, { duration }: { duration: number }) => {
          pad.rumbles.push(duration);
          return 'complete';
        },
      },
    };
    Object.assign(window, { pad });
    navigator.getGamepads = () => [pad] as unknown as Gamepad[];
  });
}

test('what a desk has stands in for a phone', async ({ room }) => {
  const program = await room.program('game');
  const { page } = await room.atDesk('Anna');
  await plugIn(page);

  await test.step('a gamepad stands in for the phone controller: sticks, buttons and rumble', async () => {
    await page.goto('/devices/gamepad');
    await expect(page.getByRole('heading', { name: 'Gamepad 1' })).toBeVisible();
    const find = async () =>
      (await program.call('deviceGetList', { elements: [{ name: 'web-interface-gamepad' }] }))
        .elements;
    await expect.poll(async () => (await find()).length).toBe(1);
    const id = (await find())[0]!.clientId;
    const told: string[] = [];
    const all = program.subscribe({ glob: `/${id}/web-interface-gamepad/*` });
    all.onRecord((record) => {
      const name = record.topic.split('/').at(-1);
      if (record.format === 'keyEvent')
        told.push(`${name} ${record.value.key} ${record.value.type}`);
      if (record.format === 'vector2') told.push(`${name} ${record.value.x} ${record.value.y}`);
    });
    await all.ready;

    type Held = {
      axes: number[];
      buttons: { pressed: boolean; value: number }[];
      rumbles: number[];
    };
    const change = async (button: number, isDown: boolean) =>
      page.evaluate(
        ([index, pressed]) => {
          const { pad } = window as unknown as { pad: Held };
          pad.buttons[index]!.pressed = pressed;
        },
        [button, isDown] as const,
      );
    await change(0, true);
    await expect.poll(() => told).toEqual(['button_a 1 1']);
    await change(0, false);
    await expect.poll(() => told).toEqual(['button_a 1 1', 'button_a 1 0']);
    await page.evaluate(() => {
      (window as unknown as { pad: Held }).pad.axes = [0, -1, 0.05, 0];
    });
    await expect.poll(() => told.at(-1)).toBe('analog_stick_left 0 1');

    program.publish(`/${id}/web-interface-gamepad/vibration_pattern`, 'double', 200);
    await expect
      .poll(async () => page.evaluate(() => (window as unknown as { pad: Held }).pad.rumbles))
      .toEqual([200]);
  });

  await test.step('keyboard and mouse stand in for a phone, on the pad only, and let go when it is left', async () => {
    await page.goto('/devices/keyboard-mouse');
    const name = 'web-interface-keyboard-mouse';
    const find = async () =>
      (await program.call('deviceGetList', { elements: [{ name }] })).elements;
    await expect.poll(async () => (await find()).length).toBe(1);
    const prefix = `/${(await find())[0]!.clientId}/${name}`;
    const keys: string[] = [];
    const mouse: string[] = [];
    let at: { x: number; y: number } | undefined;
    let stick: { x: number; y: number } | undefined;
    let wheel: { x: number; y: number } | undefined;
    const subscriptions = [
      program
        .subscribe(`${prefix}/button`, { format: 'keyEvent' })
        .onRecord(({ value }) => keys.push(`${value.key} ${value.type}`)),
      program
        .subscribe(`${prefix}/mouse_button`, { format: 'mouseEvent' })
        .onRecord(({ value }) => mouse.push(`${value.button} ${value.type}`)),
      program
        .subscribe(`${prefix}/touch_position`, { format: 'vector2' })
        .onRecord(({ value }) => (at = value)),
      program
        .subscribe(`${prefix}/analog_stick_left`, { format: 'vector2' })
        .onRecord(({ value }) => (stick = value)),
      program
        .subscribe(`${prefix}/mouse_wheel`, { format: 'vector2' })
        .onRecord(({ value }) => (wheel = value)),
    ];
    await Promise.all(subscriptions.map(({ ready }) => ready));

    await page.keyboard.press('x');
    const pad = page.getByRole('application', { name: 'Keyboard and mouse pad' });
    await pad.focus();
    await page.keyboard.down('w');
    await expect.poll(() => keys).toEqual(['w 1']);
    await expect.poll(() => stick).toEqual({ x: 0, y: 1 });

    const box = (await pad.boundingBox())!;
    await page.mouse.move(box.x + box.width * 0.25, box.y + box.height * 0.5);
    await expect.poll(() => at?.x).toBeCloseTo(0.25, 1);
    await page.mouse.down({ button: 'right' });
    await page.mouse.up({ button: 'right' });
    await expect.poll(() => mouse).toEqual(['2 1', '2 0']);
    await page.mouse.wheel(0, 120);
    await expect.poll(() => wheel).toEqual({ x: 0, y: 120 });

    await page.keyboard.press('Tab');
    await expect.poll(() => keys).toEqual(['w 1', 'w 0']);
    await expect.poll(() => stick).toEqual({ x: 0, y: 0 });
  });
});
