import { colorOf, type SeriesLook } from './series-look.ts';

/** Texts below the lines in an exported picture. */
export interface PictureText {
  readonly title: string;
  readonly names: readonly string[];
  readonly looks: readonly SeriesLook[];
}

const PADDING = 16;
const ROW = 20;

/**
 * Exports the visible plot with its legend as PNG in device pixels.
 * @param root element of the page that has the theme's colours and fonts
 */
export async function plotPicture(
  canvas: HTMLCanvasElement,
  { title, names, looks }: PictureText,
  root: HTMLElement,
): Promise<Blob | undefined> {
  const ratio = devicePixelRatio;
  const probe = root.appendChild(document.createElement('span'));
  const colorIn = (css: string): string => {
    probe.style.color = css;
    return getComputedStyle(probe).color;
  };
  const [ground, ink, soft] = ['--s1', '--ink-1', '--ink-3'].map((token) =>
    colorIn(`var(${token})`),
  ) as [string, string, string];
  const colors = looks.map((look) => colorIn(colorOf(look)));
  const face = getComputedStyle(root).fontFamily;
  probe.remove();

  const width = canvas.width / ratio;
  const height = canvas.height / ratio;
  const columns = Math.max(1, Math.floor((width - PADDING) / 180));
  const rows = Math.ceil(names.length / columns);
  const picture = document.createElement('canvas');
  picture.width = canvas.width;
  picture.height = Math.round((height + (rows + 1) * ROW + 2 * PADDING) * ratio);
  const context = picture.getContext('2d');
  if (!context) return undefined;
  context.fillStyle = ground;
  context.fillRect(0, 0, picture.width, picture.height);
  context.drawImage(canvas, 0, 0);
  context.scale(ratio, ratio);
  context.textBaseline = 'middle';
  context.font = `12px ${face}`;
  context.fillStyle = soft;
  context.fillText(title, PADDING, height + PADDING, width - 2 * PADDING);
  names.forEach((name, i) => {
    const x = PADDING + (i % columns) * 180;
    const y = height + PADDING + ROW * (1 + Math.floor(i / columns));
    context.strokeStyle = colors[i]!;
    context.lineWidth = 2;
    context.setLineDash([...looks[i]!.dash]);
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + 18, y);
    context.stroke();
    context.fillStyle = ink;
    context.fillText(name, x + 26, y, 148);
  });
  return new Promise((resolve) =>
    picture.toBlob((blob) => resolve(blob ?? undefined), 'image/png'),
  );
}
