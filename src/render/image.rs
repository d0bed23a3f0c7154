//! A finished picture in memory, written as PNG.

/// A picture: eight bits a channel, sRGB, straight alpha, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Four bytes a pixel.
    pub rgba: Vec<u8>,
}

/// How much work goes into making a file small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Packing {
    /// As small as it gets: for pictures that are kept.
    #[default]
    Small,
    /// A quarter larger in a thirtieth of the time: for the frames of a film.
    Quick,
}

impl Image {
    /// The mean of pictures of one size, byte by byte; none is a picture without pixels.
    #[must_use]
    pub fn mean(images: &[Self]) -> Self {
        let Some(first) = images.first() else { return Self { width: 0, height: 0, rgba: Vec::new() } };
        let count = images.len();
        let mean = |at: usize| {
            let sum: usize = images.iter().filter_map(|image| image.rgba.get(at)).map(|byte| usize::from(*byte)).sum();
            u8::try_from((sum + count / 2) / count).unwrap_or(u8::MAX)
        };
        Self { rgba: (0..first.rgba.len()).map(mean).collect(), ..*first }
    }

    /// The picture as a PNG file, with `texts` (keyword, text) in it; the pixels are the same however it is packed.
    ///
    /// Keywords are 1 to 79 Latin-1 characters, as PNG has them; a picture made by hand must have the bytes that its
    /// size promises. Else the file comes out empty.
    pub fn to_png(&self, texts: &[(&str, String)], packing: Packing) -> Vec<u8> {
        let mut bytes = Vec::new();
        match self.encode(&mut bytes, texts, packing) {
            Ok(()) => bytes,
            Err(_) => Vec::new(),
        }
    }

    fn encode(
        &self,
        bytes: &mut Vec<u8>,
        texts: &[(&str, String)],
        packing: Packing,
    ) -> Result<(), png::EncodingError> {
        let mut encoder = png::Encoder::new(bytes, self.width, self.height);
        let opaque = self.rgba.chunks_exact(4).all(|p| p[3] == 0xff);
        encoder.set_color(if opaque { png::ColorType::Rgb } else { png::ColorType::Rgba });
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(match packing {
            Packing::Small => png::Compression::High,
            Packing::Quick => png::Compression::Fast,
        });
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        for (keyword, text) in texts {
            encoder.add_itxt_chunk((*keyword).to_owned(), text.clone())?;
        }
        let mut writer = encoder.write_header()?;
        if opaque {
            let rgb: Vec<u8> = self.rgba.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
            writer.write_image_data(&rgb)?;
        } else {
            writer.write_image_data(&self.rgba)?;
        }
        writer.finish()
    }

    /// A PNG file's picture.
    ///
    /// # Errors
    /// When it is not an 8-bit RGB or RGBA PNG.
    pub fn from_png(bytes: &[u8]) -> Result<Self, png::DecodingError> {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::ALPHA);
        let mut reader = decoder.read_info()?;
        let mut rgba = vec![0; reader.output_buffer_size().unwrap_or(0)];
        let info = reader.next_frame(&mut rgba)?;
        rgba.truncate(info.buffer_size());
        Ok(Self { width: info.width, height: info.height, rgba })
    }
}

/// Divides colours by their alpha.
pub(super) fn straight(mut rgba: Vec<u8>) -> Vec<u8> {
    for pixel in rgba.chunks_exact_mut(4) {
        let alpha = u32::from(pixel[3]);
        if alpha != 0xff && alpha != 0 {
            for channel in &mut pixel[..3] {
                let value = (u32::from(*channel) * 255 + alpha / 2) / alpha;
                *channel = u8::try_from(value.min(255)).unwrap_or(255);
            }
        }
    }
    rgba
}
