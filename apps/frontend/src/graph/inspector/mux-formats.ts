import { DATA_FORMATS, type DataFormat } from '@ubii/proto';

/** Matches records of any format. */
export const ANY_FORMAT = 'any';

/** Data formats that muxers and demuxers can be limited to. */
export const MUX_FORMATS: readonly { readonly value: string; readonly text: string }[] = [
  { value: ANY_FORMAT, text: ANY_FORMAT },
  ...(Object.keys(DATA_FORMATS) as DataFormat[])
    .filter((format) => !DATA_FORMATS[format].isList)
    .map((format) => ({ value: format, text: format })),
];
