import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { Fingers } from '../../pages/touch.ts';

async function aSession(master: MasterProcess, ...names: readonly string[]): Promise<string> {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: { name: 'Touch', processingModules: names.map((name) => ({ name })) },
  });
  return session!.id;
}

test('a session is edited and used in the list on a phone', async ({ room, master }) => {
  const { page } = await room.withPhone('Ines');
  const fingers = await Fingers.on(page);
  const list = page.getByRole('list', { name: 'Nodes of the graph' });
  await test.step('a phone wires its own touch in the list, and sees it arrive', async () => {
    const other = await room.withPhone('Ben');
    await other.page.goto('/devices/smart-device');
    await other.page.getByRole('application').first().tap();
    await page.goto('/sessions/new');
    const next = page.getByText(/^Next: /);
    const toast = page.getByText(/^(Added|Connected) /);
    const input = list.getByRole('button', { name: /^Input pointer/ });

    await test.step('the list says what comes next', async () => {
      await page.getByRole('button', { name: 'Add', exact: true }).tap();
      await page.getByRole('combobox', { name: 'Add to the session' }).fill('mirror-pointer');
      await page
        .getByRole('option', { name: /mirror-pointer/ })
        .first()
        .tap();
      await expect(next).toHaveText(/press the input “pointer” of mirror-pointer/);
    });

    await test.step('topics of this phone come first, and a sheet has no message over it', async () => {
      await expect(toast).toHaveText('Added mirror-pointer');
      await input.tap();
      await expect(toast).toBeHidden();
      const first = page.getByRole('option').first();
      await expect(first).toContainText('touch_position');
      await expect(first).toContainText('this phone');
      await first.tap();
      await expect(toast).toHaveText('Connected touch_position to mirror-pointer · pointer');
    });

    await test.step('a switch is as large as a finger', async () => {
      await list.getByRole('button', { name: /^Input mirrorX/ }).tap();
      const { height, width } = (await page
        .getByRole('switch', { name: 'Value of mirrorX' })
        .boundingBox())!;
      expect(Math.min(height, width)).toBeGreaterThanOrEqual(44);
      await page.getByRole('button', { name: 'Close' }).tap();
    });

    await test.step('the pad opens with the session, and the touch arrives', async () => {
      await page.getByRole('button', { name: /Save and start/ }).tap();
      await expect(page.getByRole('button', { name: 'Close the pad' })).toBeVisible();
      await expect(input).toContainText('not touched');
      await page.getByRole('application').tap();
      await expect(input).toContainText(/0\.\d/);
      await page.getByRole('button', { name: 'Close the pad' }).tap();
      await expect(page.getByRole('application')).toBeHidden();
    });
  });

  await test.step('on a phone, modules are added, bound and started in the list', async () => {
    const wave = await room.program('wave');
    wave.publish('/wave/height', 'double', 4);
    wave.publish('/wave/place', 'vector2', { x: 1, y: 2 });
    await page.goto(`/sessions/${await aSession(master)}`);

    await test.step('a module is added', async () => {
      await page.getByRole('button', { name: 'Add', exact: true }).tap();
      await page.getByRole('combobox', { name: 'Add to the session' }).fill('low-pass');
      await page.getByRole('option', { name: /^low-pass / }).tap();
      await expect(list.getByRole('heading', { name: 'low-pass' })).toBeVisible();
    });

    const input = list.getByRole('button', { name: /^Input value/ });
    await test.step('what does not fit says why, and what would make it fit', async () => {
      await input.tap();
      await page.getByRole('option', { name: /^place \/wave / }).tap();
      const refusal = page.getByRole('dialog').getByRole('alert');
      await expect(refusal).toContainText('outputs vector2');
      await expect(refusal.getByRole('button', { name: 'Take x', exact: true })).toBeVisible();
      await refusal.getByRole('button', { name: 'Cancel' }).tap();
    });

    await test.step('what fits is read, and shows its value', async () => {
      await page.getByRole('option', { name: /^height \/wave / }).tap();
      await expect(page.getByRole('dialog')).toBeHidden();
      await expect(input).toContainText('/wave/height');
      await expect(input).toContainText('4.00');
    });

    await test.step('its output is led to a topic, it is started, and the value comes out', async () => {
      const output = list.getByRole('button', { name: /^Output smoothed/ });
      await output.tap();
      await page.getByRole('combobox', { name: 'Find source or topic' }).fill('/wave/smooth');
      await page.getByRole('option', { name: 'New topic /wave/smooth' }).tap();
      await expect(output).toContainText('/wave/smooth');
      await page.getByRole('button', { name: /^(Save and start|Start)$/ }).tap();
      await expect(page.getByRole('toolbar', { name: 'Session controls' })).toContainText(
        'Running',
      );
      wave.publish('/wave/height', 'double', 5);
      await expect(output).toContainText(/\d\.\d\d/);
    });

    await test.step('on a phone the graph is a list, with its life', async () => {
      await expect(list).toContainText('low-pass');
      await page.getByRole('button', { name: 'Show as a graph' }).tap();
      await expect(page.getByRole('group', { name: 'Module low-pass' })).toBeVisible();
      await page.getByRole('button', { name: 'Show as a list' }).tap();
    });

    await test.step('what is removed comes back', async () => {
      await page.getByRole('button', { name: 'Actions for low-pass' }).tap();
      await page.getByRole('menuitem', { name: 'Delete', exact: true }).tap();
      await expect(list.getByRole('heading', { name: 'low-pass' })).toBeHidden();
      await page.getByRole('button', { name: 'Undo', exact: true }).last().tap();
      await expect(list.getByRole('heading', { name: 'low-pass' })).toBeVisible();
    });
  });

  await test.step('on a phone, a session that runs is touched below its list', async () => {
    await page.goto(`/sessions/${await aSession(master, 'position-color')}`);
    const position = list.getByRole('button', { name: /^Input position/ });
    const pad = page.getByRole('application', { name: 'Touch pad' });

    await test.step('the pad opens with the start, and nothing is wrong', async () => {
      await position.tap();
      await page.getByRole('option', { name: /^touch_position this phone/ }).tap();
      await list.getByRole('button', { name: /^Output color/ }).tap();
      await page.getByRole('combobox', { name: 'Find source or topic' }).fill('/colour');
      await page.getByRole('option', { name: 'New topic /colour' }).tap();
      await page.getByRole('button', { name: /^(Save and start|Start)$/ }).tap();
      await expect(pad).toBeVisible();
      await expect(pad).toContainText('Touch here');
      await expect(position).toContainText('not touched');
      await expect(page.getByRole('button', { name: /problem/ })).toBeHidden();
    });

    await test.step('a touch gives a colour', async () => {
      await fingers.tapOn(pad);
      await expect(position).toContainText('0.500, 0.500');
      await expect(pad).not.toContainText('Touch here');
      await expect(list.getByRole('button', { name: /^Output color/ })).toContainText(/\d\.\d \d/);
    });

    await test.step('the phone stays touchable in the graph view', async () => {
      await page.getByRole('button', { name: 'Show as a graph' }).tap();
      await expect(pad).toBeVisible();
      await expect(page.getByRole('group', { name: /touch_position/ }).first()).toContainText(
        '0.500',
      );
      await page.getByRole('button', { name: 'Show as a list' }).tap();
    });

    await test.step('a closed pad is no problem', async () => {
      await page.getByRole('button', { name: 'Close the pad' }).tap();
      await expect(pad).toBeHidden();
      await expect(position).toContainText('not touched');
      await expect(page.getByRole('button', { name: /problem/ })).toBeHidden();
    });
  });
});
