// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { h } from 'vue';
import UiButton from '../UiButton.vue';
import UiTooltip from '../UiTooltip.vue';
import { placeTooltip } from './place-tooltip.ts';

const viewport = { width: 400, height: 300 };
const size = { width: 100, height: 20 };

describe('placeTooltip', () => {
  it('stands centred on its side', () => {
    const target = { left: 150, top: 100, width: 40, height: 30 };
    expect(placeTooltip(target, size, viewport, 'bottom')).toEqual({ left: 120, top: 136 });
    expect(placeTooltip(target, size, viewport, 'right')).toEqual({ left: 196, top: 105 });
  });

  it('goes to the other side where there is no room, and never leaves the window', () => {
    const low = { left: 150, top: 270, width: 40, height: 30 };
    expect(placeTooltip(low, size, viewport, 'bottom').top).toBe(244);
    const corner = { left: 380, top: 0, width: 20, height: 20 };
    expect(placeTooltip(corner, size, viewport, 'bottom').left).toBe(292);
  });
});

describe('a disabled button', () => {
  it('keeps its place and its words, says why, and does nothing', async () => {
    const button = mount(UiButton, {
      props: { disabled: 'No client is connected.' },
      slots: { default: 'Send' },
    });
    await button.trigger('click');
    expect(button.emitted('click')).toBeUndefined();
    expect(button.attributes()).toMatchObject({
      'aria-disabled': 'true',
      'aria-description': 'No client is connected.',
      'data-tooltip': 'No client is connected.',
    });
    await button.setProps({ disabled: undefined });
    await button.trigger('click');
    expect(button.emitted('click')).toHaveLength(1);
  });
});

it('a tooltip adds attributes to the one element in its slot, and no element', () => {
  const wrapper = mount(UiTooltip, {
    props: { text: 'Topics', shortcut: 'G T' },
    slots: { default: () => h('a', { class: 'link' }, 'T') },
  });
  expect(wrapper.html()).toBe(
    '<a class="link" data-tooltip="Topics" data-tooltip-keys="G T" data-tooltip-side="bottom">T</a>',
  );
});
