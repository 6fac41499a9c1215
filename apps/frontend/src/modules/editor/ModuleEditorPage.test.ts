// @vitest-environment happy-dom
import { flushPromises, mount } from '@vue/test-utils';
import { afterAll, expect, it, vi } from 'vitest';
import { defineComponent, h, ref } from 'vue';
import { createMemoryHistory, createRouter, RouterView } from 'vue-router';
import ModuleEditorPage from './ModuleEditorPage.vue';

// Test files share modules: reset them before and after mocking.
vi.hoisted(() => vi.resetModules());
afterAll(() => void vi.resetModules());
vi.mock('./ModuleWorkbench.vue', () => ({
  default: defineComponent({
    name: 'ModuleWorkbench',
    props: { address: { type: String, required: true } },
    emits: ['savedAs'],
    setup(props, { emit }) {
      const input = ref('');
      return () => [
        h('input', {
          value: input.value,
          onInput: (event: Event) => (input.value = (event.target as HTMLInputElement).value),
        }),
        h('button', { onClick: () => emit('savedAs', 'mirror') }, props.address),
      ];
    },
  }),
}));

it('keeps the editor with its try-out when a new module is saved, and opens another for another module', async () => {
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/modules/:name/edit', component: ModuleEditorPage }],
  });
  await router.push('/modules/new-1/edit');
  const page = mount(RouterView, { global: { plugins: [router] } });
  await flushPromises();
  await page.find('input').setValue('0.5');
  await page.find('button').trigger('click');
  await router.replace('/modules/mirror/edit');
  await flushPromises();
  expect(page.find('button').text()).toBe('mirror');
  expect(page.find('input').element.value).toBe('0.5');
  await router.push('/modules/other/edit');
  await flushPromises();
  expect(page.find('input').element.value).toBe('');
});
