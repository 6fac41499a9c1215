import { describe, expect, it } from 'vitest';
import { createMemoryHistory, createRouter } from 'vue-router';
import { topicLocation } from '../locations/topic-location.ts';
import { topicsRoutes } from './routes.ts';

describe('topicLocation', () => {
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [
      ...topicsRoutes(
        async () => ({ template: '<p />' }),
        async () => ({ template: '<p />' }),
      ),
    ],
  });

  it.each([
    '/mara/smart-device/acceleration',
    'no-slash',
    '/file.json',
    '/a b/ä?x=1#y',
    '/100%',
    '//',
  ])('leads back to %s', (topic) => {
    const { href } = router.resolve(topicLocation(topic));
    expect(href).not.toMatch(/[.?#]/);
    expect(router.resolve(href).params.topic).toBe(topic);
  });
});
