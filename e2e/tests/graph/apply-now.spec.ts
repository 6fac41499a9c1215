import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

const WAVE = {
  name: 'Wave',
  description: 'Generates a wave. Change waveHz of “clock”, and watch “wave”.',
  processingModules: [{ name: 'clock' }],
  ioMappings: [
    {
      processingModuleName: 'clock',
      outputMappings: [{ outputName: 'sine', topic: '/wave' }],
    },
  ],
};

test('a running session is described, and takes values when they are applied', async ({ room }) => {
  const robot = await room.program('Robot');
  const { id } = await robot.call('sessionRuntimeStart', WAVE);
  const anna = new GraphPage(await room.atDesk('Anna'));
  await anna.open(id);
  await test.step('the description of a session stands over its graph until it is dismissed', async () => {
    const hint = anna.page.getByRole('region', { name: 'About this session' });
    await expect(hint).toContainText(WAVE.description);
    await hint.getByRole('button', { name: 'Dismiss the description' }).click();
    await expect(hint).toBeHidden();
    await anna.open(id);
    await expect(anna.node('Module clock')).toBeVisible();
    await expect(hint).toBeHidden();
  });

  await test.step('a value that a running session does not have yet says so, and applies by a click or by keys', async () => {
    const constants = async (): Promise<unknown[]> => {
      const { ioMappings } = await robot.call('sessionRuntimeGet', { id });
      return ioMappings.flatMap(({ inputMappings }) =>
        inputMappings.map(({ constantJson }) => JSON.parse(constantJson ?? 'null') as unknown),
      );
    };
    const clock = anna.node('Module clock');
    const field = clock.getByRole('textbox', { name: 'Value of waveHz' });
    const unapplied = clock.getByText('Not applied yet');
    await field.fill('3');
    await field.press('Enter');
    await expect(unapplied).toBeVisible();
    expect(await constants()).toEqual([]);
    await clock.getByRole('button', { name: 'Apply now' }).click();
    await expect(unapplied).toBeHidden();
    await expect.poll(constants).toEqual([{ double: 3 }]);

    await test.step('Ctrl Enter in the field commits and applies', async () => {
      await field.fill('4');
      await field.press('Control+Enter');
      await expect.poll(constants).toEqual([{ double: 4 }]);
      await expect(unapplied).toBeHidden();
    });

    await test.step('what goes back to what runs needs no apply', async () => {
      await field.fill('5');
      await field.press('Enter');
      await expect(unapplied).toBeVisible();
      await field.fill('4');
      await field.press('Enter');
      await expect(unapplied).toBeHidden();
    });
  });
});
