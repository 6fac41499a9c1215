import { moduleLibrary } from '@ubii/modules';
import { fromJson } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aSession } from '../../../sessions/testing/a-session.ts';
import { graphOf } from '../../model/graph-of.ts';
import { findAddables } from '../addable.ts';
import { categoriesOf } from './categories.ts';

const topics = [{ topic: '/a/point', format: 'vector2' }];
const all = findAddables(graphOf(aSession()), { modules: moduleLibrary(), topics }, '', {});

describe('categories of what can be added', () => {
  it('are all, favourites, what was used lately, common tags, topics, and the rest', () => {
    const texts = categoriesOf(all, { favourites: ['noise'], recent: ['clock'] }).map(
      ({ text }) => text,
    );
    expect(texts[0]).toBe('All');
    expect(texts.slice(1, 3)).toEqual(['Favourites', 'Recent']);
    expect(texts.slice(-2)).toEqual(['Topics', 'Muxers, notes']);
    expect(texts).toContain('Filter');
    expect(texts.length).toBeLessThanOrEqual(14);
  });

  it('have what they count', () => {
    for (const { has, count } of categoriesOf(all, {
      favourites: ['noise', 'mix'],
      recent: ['clock'],
    }))
      expect(all.filter((one) => has(one))).toHaveLength(count);
  });

  it('are left out where they would be empty, and tags where few modules share them', () => {
    const module = fromJson('ubii.processing.ProcessingModule', { name: 'one', tags: ['rare'] });
    const few = findAddables(graphOf(aSession()), { modules: [module], topics: [] }, '', {});
    const groups = categoriesOf(few, { favourites: [], recent: [] });
    expect(groups.map(({ text }) => text)).toEqual(['All', 'Muxers, notes']);
  });
});
