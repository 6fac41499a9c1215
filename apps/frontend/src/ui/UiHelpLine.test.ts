// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { nextTick } from 'vue';
import { afterEach, describe, expect, it, vi } from 'vitest';
import UiHelpLine from './UiHelpLine.vue';

/** Mounts a line with this text in a box with room for a number of letters. */
async function show(text: string, letters: number) {
  vi.spyOn(HTMLElement.prototype, 'clientWidth', 'get').mockReturnValue(letters);
  vi.spyOn(HTMLElement.prototype, 'scrollWidth', 'get').mockReturnValue(text.length);
  const line = mount(UiHelpLine, { props: { text: '' }, attachTo: document.body });
  await line.setProps({ text });
  await nextTick();
  return line;
}

afterEach(() => vi.restoreAllMocks());

describe('UiHelpLine', () => {
  it('is words alone where they fit', async () => {
    const line = await show('Time of a run, ms.', 40);
    expect(line.text()).toBe('Time of a run, ms.');
    expect(line.find('button').exists()).toBe(false);
    expect(line.find('[data-tooltip]').exists()).toBe(false);
  });

  it('shows what does not fit by a tooltip, and by a press', async () => {
    const line = await show('Time of a run, ms.', 9);
    const button = line.get('button');
    expect(button.attributes()).toMatchObject({
      'aria-expanded': 'false',
      'data-tooltip': 'Time of a run, ms.',
    });
    await button.trigger('click');
    expect(button.attributes('aria-expanded')).toBe('true');
    expect(button.attributes('data-tooltip')).toBeUndefined();
    expect(button.classes()).not.toContain('truncate');
  });
});
