// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';
import { keepInstallOffer } from './install-offer.ts';
import InstallHint from './InstallHint.vue';

keepInstallOffer();
let isStandalone = false;

beforeEach(() => {
  localStorage.clear();
  isStandalone = false;
  vi.stubGlobal('matchMedia', () => ({ matches: isStandalone }));
  vi.stubGlobal('isSecureContext', true);
});
afterEach(() => {
  dispatchEvent(new Event('appinstalled'));
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

/** Fires the event of an install prompt; the browser's own banner is suppressed. */
function offer() {
  const prompt = vi.fn(() => Promise.resolve({ outcome: 'accepted' }));
  const event = Object.assign(new Event('beforeinstallprompt', { cancelable: true }), { prompt });
  dispatchEvent(event);
  expect(event.defaultPrevented).toBe(true);
  return prompt;
}

it('shows nothing where the browser offers nothing', () => {
  expect(mount(InstallHint).text()).toBe('');
});

it('takes an offer that came before the page, once', async () => {
  const prompt = offer();
  const hint = mount(InstallHint);
  await hint.get('button').trigger('click');
  expect(prompt).toHaveBeenCalledOnce();
  expect(hint.text()).toBe('');
});

it('does not ask a user again who declined', async () => {
  offer();
  const hint = mount(InstallHint);
  await hint.findAll('button')[1]!.trigger('click');
  expect(hint.text()).toBe('');
  await nextTick();
  expect(localStorage.getItem('ubii.install.declined')).toBe('true');
  offer();
  expect(mount(InstallHint).text()).toBe('');
});

it('says how on iOS, which has no button for it', () => {
  vi.spyOn(navigator, 'userAgent', 'get').mockReturnValue('Mozilla/5.0 (iPhone; CPU iPhone OS 18)');
  const hint = mount(InstallHint);
  expect(hint.text()).toContain('Tap Share, then “Add to Home Screen”.');
  expect(hint.findAll('button').map((button) => button.text())).toEqual(['Not now']);
});

it('is not for the installed app itself', () => {
  isStandalone = true;
  offer();
  expect(mount(InstallHint).text()).toBe('');
});
