// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import UiIconButton from './UiIconButton.vue';

const show = (disabled?: string | boolean) =>
  mount(UiIconButton, { props: { label: 'Pause', disabled } });

describe('UiIconButton', () => {
  it.each([undefined, false])('can be pressed when disabled is %s, as menus say it', async (no) => {
    const button = show(no);
    await button.trigger('click');
    expect(button.emitted('click')).toHaveLength(1);
    expect(button.attributes('aria-disabled')).toBeUndefined();
    expect(button.attributes('aria-description')).toBeUndefined();
  });

  it('says why it is disabled, and does nothing', async () => {
    const button = show('This page is not connected to the master.');
    await button.trigger('click');
    expect(button.emitted('click')).toBeUndefined();
    expect(button.attributes()).toMatchObject({
      'aria-disabled': 'true',
      'aria-description': 'This page is not connected to the master.',
    });
  });
});
