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

test('a running session is described, and takes values at once', async ({ room }) => {
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

  await test.step('a value applies while the session runs, without a button [SE-15]', async () => {
    const constants = async (): Promise<unknown[]> => {
      const { ioMappings } = await robot.call('sessionRuntimeGet', { id });
      return ioMappings.flatMap(({ inputMappings }) =>
        inputMappings.map(({ constantJson }) => JSON.parse(constantJson ?? 'null') as unknown),
      );
    };
    const clock = anna.node('Module clock');
    const field = clock.getByRole('textbox', { name: 'Value of waveHz' });
    await expect(anna.life).toContainText('Applied');
    await field.fill('3');
    await field.press('Enter');
    await expect.poll(constants).toEqual([{ double: 3 }]);
    await expect(anna.life).toContainText('Applied');

    await test.step('undo applies, too', async () => {
      await anna.canvas.focus();
      await anna.page.keyboard.press('Control+z');
      await expect.poll(constants).toEqual([]);
    });

    await test.step('what restarts a module waits for a button that says so', async () => {
      await anna.life.getByRole('button', { name: /^Runs on / }).click();
      await anna.page.getByRole('combobox', { name: 'Where clock runs' }).click();
      await anna.page.getByRole('option', { name: /^This tab/ }).click();
      await anna.page.keyboard.press('Escape');
      // The tab becomes a node first, and a value that comes before that is applied at once.
      const apply = anna.life.getByRole('button', { name: 'Apply, 1 module restarts' });
      await expect(apply).toBeVisible();
      await field.fill('4');
      await field.press('Enter');
      await expect(clock.getByText('Not applied yet')).toBeVisible();
      await apply.click();
      await expect(clock.getByText('Not applied yet')).toBeHidden();
      await expect.poll(constants).toEqual([{ double: 4 }]);
      await expect(anna.life).toContainText('Applied');
    });
  });
});
