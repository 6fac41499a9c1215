import { lineCounter } from './lines.mjs';
import { passagesOf } from './files.mjs';

/**
 * The texts on screens, each once for each file, by feature: the folder below `src`.
 *
 * @param {readonly { path: string, source: string }[]} files
 * @param {string} [under] only files whose path begins so, from the root
 * @returns {Map<string, string[]>} for each feature its lines: place, and text with … for what is put in
 */
export function textsOfScreens(files, under = '') {
  const features = new Map();
  for (const { path, source } of files.filter((file) => file.path.startsWith(under))) {
    const passages = passagesOf(path, source).filter(({ place }) => place === 'screens');
    if (passages.length === 0) continue;
    const locate = lineCounter(source);
    const texts = new Map();
    for (const { start, text } of passages.sort((a, b) => a.start - b.start)) {
      const lead = text.length - text.trimStart().length;
      const shown = text.replace(/#+/g, '…').replace(/\s+/g, ' ').trim();
      if (!texts.has(shown)) texts.set(shown, locate(start + lead).line);
    }
    const feature = path.match(/^.*?\/src\/[^/]+/)?.[0] ?? path;
    const lines = [...texts].map(([text, line]) => `${path}:${line} ${text}`);
    features.set(feature, [...(features.get(feature) ?? []), ...lines]);
  }
  return features;
}
