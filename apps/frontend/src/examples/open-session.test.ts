// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import { createApp, h } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import OpenSession from './OpenSession.vue';

it('opens the session in a new tab, so that the page that owns it stays', () => {
  const app = createApp({ render: () => h(OpenSession, { id: 'a b' }) });
  const routes = [{ path: '/:rest(.*)*', component: { render: () => null } }];
  app.use(createRouter({ history: createMemoryHistory(), routes }));
  const host = document.createElement('div');
  app.mount(host);
  const link = host.querySelector('a');
  expect(link?.getAttribute('href')).toBe('/sessions/a%20b');
  expect(link?.target).toBe('_blank');
  app.unmount();
});

it('no link on the page of an example leaves the page', () => {
  const pages = import.meta.glob<string>(['./*/**/*.vue', './OpenSession.vue'], {
    query: '?raw',
    import: 'default',
    eager: true,
  });
  const leaving = Object.entries(pages).flatMap(([path, text]) =>
    (text.match(/<(RouterLink|UiButton)\s[^>]*:to=[^>]*>/g) ?? [])
      .filter((link) => !link.includes('target="_blank"'))
      .map((link) => `${path} ${link}`),
  );
  expect(leaving).toEqual([]);
});
